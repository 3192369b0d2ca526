/* The sizes of the table that the library was built with. The example table_header writes this
file. */

#ifndef EIGENSHADE_TABLE_H
#define EIGENSHADE_TABLE_H

/** A checksum of these sizes: compare it with `eigenshade_table()`. */
#define EIGENSHADE_TABLE 3950693635u

/** Largest degree l of a light. */
#define EIGENSHADE_DEGREE 9

/** Largest order o of a material. */
#define EIGENSHADE_ORDER 7

/** Coefficients of a light of that degree. */
#define EIGENSHADE_LIGHT 100

/** Coefficients of a material of that order. */
#define EIGENSHADE_MATERIAL 40

/** Components d of an image. */
#define EIGENSHADE_COMPONENTS 46

/** Profiles of a table in integers. */
#define EIGENSHADE_PROFILES 26

/** Numbers in a transfer in float. */
#define EIGENSHADE_TRANSFER_F32 568

/** Numbers in a transfer in integers. */
#define EIGENSHADE_TRANSFER 207

/** Numbers of a scene in float. */
#define EIGENSHADE_SCENE_F32 167

/** Numbers of a scene in Q15. */
#define EIGENSHADE_SCENE_Q15 130

/** Numbers in the workspace of transfers and projections in float. */
#define EIGENSHADE_WORKSPACE_F32 460

/** Numbers in the workspace of transfers in integers. */
#define EIGENSHADE_WORKSPACE 230

#endif
