namespace Nowpose.Web.Messages;

/// <summary>Text of pages without plots, for builds without Node.js.</summary>
static class PlainTexts
{
    public const string NoPlots =
        "This page has no plots: Nowpose was built without Node.js. Install Node.js 20 or newer with npm, build again, and the next page has them.";
    public const string Claims = "The paper’s claims and this run";

    public static string NotComputed(string figures) => $"Not computed, because the run was interrupted: {figures}.";
    public static string NotMeasured(string caption) => $"{caption}: not measured in this run.";
}
