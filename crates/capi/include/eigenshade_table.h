/* The sizes of the table that the library was built with. The example table_header writes this
file. */

#ifndef EIGENSHADE_TABLE_H
#define EIGENSHADE_TABLE_H

/** A checksum of these sizes: compare it with `eigenshade_table()`. */
#define EIGENSHADE_TABLE 3597171090u

/** Largest degree l of a light. */
#define EIGENSHADE_DEGREE 9

/** Largest order o of a material. */
#define EIGENSHADE_ORDER 7

/** Coefficients of a light of that degree. */
#define EIGENSHADE_LIGHT 100

/** Coefficients of a material of that order. */
#define EIGENSHADE_MATERIAL 40

/** Coefficients that memory for a material has. */
#define EIGENSHADE_MATERIAL_BUFFER 40

/** Exponents that memory for a material has. */
#define EIGENSHADE_MATERIAL_EXPONENTS 8

/** Components d of an image. */
#define EIGENSHADE_COMPONENTS 46

/** Profiles of a table in integers. */
#define EIGENSHADE_PROFILES 26

/** Numbers of a channel of a transfer in float. */
#define EIGENSHADE_TRANSFER_F32 568

/** Numbers of a channel of a transfer in integers. */
#define EIGENSHADE_TRANSFER_Q15 207

/** Numbers in the workspace of projections in float. */
#define EIGENSHADE_WORKSPACE_F32 460

/** Numbers in the workspace of projections in integers. */
#define EIGENSHADE_WORKSPACE_Q15 230

/** The most sources of a picture. */
#define EIGENSHADE_SOURCES 16

/** Words of 64 bits in a picture in float. */
#define EIGENSHADE_PICTURE_F32 375

/** Words of 64 bits in a picture in integers. */
#define EIGENSHADE_PICTURE_Q15 370

/** Words of 64 bits in the nodes of an object. */
#define EIGENSHADE_NODES 34

/** Words of 32 bits in a palette. */
#define EIGENSHADE_PALETTE 2179

/** Words of 32 bits in a linear palette. */
#define EIGENSHADE_LINEAR_PALETTE 3268

/** Words of 32 bits in the coefficients of an object with shadows. */
#define EIGENSHADE_OBJECT_COEFFICIENTS 154

#endif
