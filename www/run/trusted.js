/** The widest swing that the engine calls one of this model, in rad: the 29° of the words. */
export const trusted = 0.5;
