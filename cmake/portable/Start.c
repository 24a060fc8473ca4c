/* The program voxc where all of it lies in libvoxc.so: this only begins. The start that the compiler links into programs asks for a C
 * library as new as that of this system. */
int voxc_main(int count, char **words);
int __libc_start_main(int (*)(int, char **), int, char **, void (*)(void), void (*)(void), void (*)(void), void *);

/* The stack has the count of words and the words; the third argument is what the loader wants called at the end. */
__attribute__((noreturn, used, visibility("hidden"))) void begin(long *stack, void (*atEnd)(void)) {
  __libc_start_main(voxc_main, (int)stack[0], (char **)(stack + 1), 0, 0, atEnd, stack);
  __builtin_unreachable();
}

#ifdef __aarch64__
__asm__(".globl _start\n_start:\n mov x29, #0\n mov x30, #0\n mov x1, x0\n mov x0, sp\n bl begin\n");
#else
__asm__(".globl _start\n_start:\n xor %ebp, %ebp\n mov %rsp, %rdi\n mov %rdx, %rsi\n and $-16, %rsp\n call begin\n hlt\n");
#endif
