namespace Nowpose.Vision;

/// <summary>Error messages about the process that reads pictures, with remedies.</summary>
static class PictureReaderMessages
{
    public const string NodeNeeded = "Node.js 20 or newer is needed to read pictures";
    public const string Stopped = "the picture reader stopped at this picture; it may be too large, so try a smaller one";

    public static string Ended(string script, string errors) =>
        $"the picture reader ended unexpectedly ({script}); free memory, or install Nowpose again: {errors}";
}
