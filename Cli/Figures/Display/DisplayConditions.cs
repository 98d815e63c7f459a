namespace Nowpose.Cli.Figures.Display;

/// <summary>The conditions of Figs 10 and 11.</summary>
static class DisplayConditions
{
    public const string Words = "A simulated display of 60 Hz: render time 4 ms and 8.5 ms per million vertices, ± 3 %, one frame in a hundred "
        + "much slower; frames are ready 1.5 ms before the refresh that shows them or wait for the next; two may be under way. The camera errs by 0.7 ms. "
        + "Where the limit lies, and how long L_visu is, is a headset's own: the figure shows the shape, not the HoloLens's numbers.";
}
