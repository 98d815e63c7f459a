namespace Nowpose.Cli.Figures.Model;

/// <summary>Names of line styles, the same in all figures. Each has a colour, width and dash in the page's <c>looks.ts</c>.</summary>
static class Looks
{
    public const string Truth = "truth";
    public const string Hold = "hold";
    public const string Adaptive = "adaptive";
    public const string Process = "gp";
    public const string Quadratic = "quadratic";
    public const string Linear = "linear";
    public const string Cubic = "cubic";
    public const string Samples = "samples";

    /// <summary>Gets the style of a predictor or clock estimator by its name: ours, the paper's, or others.</summary>
    public static string Of(string method) => method switch
    {
        "default" => Adaptive,
        "ransac" => Quadratic,
        "quadratic-h3" => Linear,
        "quadratic-h4" => Cubic,
        _ => method,
    };
}
