using System.CommandLine;
using System.Globalization;
using Nowpose.Motion;

namespace Nowpose.Cli.Studies;

/// <summary>Limits of a move: mm/s, mm/s² and mm/s³.</summary>
readonly record struct MotionLimits(double Velocity, double Acceleration, double Jerk)
{
    const double Stroke = 500, Min = 1, Max = 1e9;

    /// <summary>The limits of <see cref="Motions.PaperMove"/>. The paper does not state them, so these values are assumptions.</summary>
    public static MotionLimits Default { get; } = new(1000, 5000, 50_000);

    /// <summary>Creates the option <c>--limits V,A,J</c>.</summary>
    public static Option<MotionLimits> Option() => new("--limits")
    {
        Description = "Maximum velocity, acceleration and jerk of the swing of Figs 13 and 14, mm/s, mm/s² and mm/s³", HelpName = "V,A,J",
        DefaultValueFactory = _ => Default,
        CustomParser = result =>
        {
            var numbers = result.Tokens.Single().Value.Split(',').Select(part =>
                double.TryParse(part, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) ? value : double.NaN).ToArray();
            if (numbers.Length == 3 && numbers.All(value => value is >= Min and <= Max)) return new(numbers[0], numbers[1], numbers[2]);
            result.AddError(OptionValueMessages.Limits("--limits", result.Tokens[0].Value));
            return default;
        },
    };

    /// <summary>Creates a move of 500 mm with these limits.</summary>
    public SevenPhaseProfile Move() => new(Stroke, Velocity, Acceleration, Jerk);

    /// <summary>The limits with their units.</summary>
    public string Text => FigurePageTexts.Limits(Velocity, Acceleration, Jerk);

    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Velocity},{Acceleration},{Jerk}");
}
