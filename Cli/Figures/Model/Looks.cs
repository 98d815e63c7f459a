namespace Nowpose.Cli.Figures.Model;

/// <summary>Names of the line styles, which are the same in all figures. The page's <c>looks.ts</c> defines their colour, width and dash.</summary>
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

    /// <summary>Gets the style for the name of a predictor or clock estimator.</summary>
    public static string Of(string method) => method switch
    {
        "default" => Adaptive,
        "ransac" => Quadratic,
        "quadratic-h3" => Linear,
        "quadratic-h4" => Cubic,
        _ => method,
    };
}
