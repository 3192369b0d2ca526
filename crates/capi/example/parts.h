/* What every machine has to find. */
#ifndef PARTS_H
#define PARTS_H

/* The golden vectors (golden_vectors.c). */
void check_golden_vectors(void);

/* What the library answers to arguments at fault (faults.c). */
void check_faults(void);

/* The same of what is drawn (target_faults.c). */
void check_target_faults(void);

/* The same of textured objects (object_faults.c). */
void check_object_faults(void);

/* Pictures in color (color.c). */
void check_color(void);

/* Textured objects (textured.c). */
void check_textured(void);

/* Objects with shadows (shadowed.c). */
void check_shadowed(void);

#endif
