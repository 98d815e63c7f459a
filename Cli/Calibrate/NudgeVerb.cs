using System.CommandLine;
using System.CommandLine.Parsing;
using Nowpose.Gateway.Options;
using Nowpose.Latency.Profile;

namespace Nowpose.Cli.Calibrate;

/// <summary>
/// <c>calibrate nudge</c>: measures L_visu by eye, from the offsets at which hologram and robot coincide in two directions of motion.
/// </summary>
static class NudgeVerb
{
    static readonly Option<double?> Speed = NumberOption.CreateOptional("--speed-mm-s", "Constant speed of the tool", 1.0, 10_000, "mm/s");
    static readonly Option<double> Configured = NumberOption.Create("--visu-ms", "L_visu that the headset used", 40.0, 0, 500, "ms");
    static readonly Option<double?> Former = FormerVisuOption.Create(Configured);
    static readonly Option<double[]> Forward = Offsets("--forward-mm", "forwards");
    static readonly Option<double[]> Backward = Offsets("--backward-mm", "backwards");
    static readonly Option<string> Earlier = EarlierProfile.Option();
    static readonly CalibrationOptions Shared = new();

    public static Command Create()
    {
        var verb = new Command("nudge", "Determine L_visu by eye, from the offsets at which hologram and robot coincide in both directions of motion. Without options: print the instructions.")
        {
            Speed, Configured, Former, Forward, Backward, Earlier,
        };
        Shared.AddTo(verb);
        verb.SetAction(RunAsync);
        return verb;
    }

    static async Task<int> RunAsync(ParseResult parsed, CancellationToken cancel)
    {
        if (parsed.CommandResult.Children.OfType<OptionResult>().All(option => option.Implicit))
        {
            Console.Out.Write(NudgeGuide.Text);
            return ExitStatus.Done;
        }
        var speed = parsed.GetValue(Speed) ?? throw new InputException(CalibrationMessages.NoSpeed);
        var (forward, backward) = (parsed.GetValue(Forward), parsed.GetValue(Backward));
        if (forward.Length == 0) throw new InputException(CalibrationMessages.NoOffset(Forward.Name));
        if (backward.Length == 0) throw new InputException(CalibrationMessages.NoOffset(Backward.Name));
        var configuredMs = parsed.GetValue(Former) ?? parsed.GetValue(Configured);
        var marks = new NudgeMarks(speed, configuredMs, forward, backward);
        var result = marks.Result();
        var earlier = await Invocation.ReadAsync(() => EarlierProfile.Read(parsed.GetValue(Earlier), Shared.Conditions(parsed)), cancel);
        var output = Shared.Output(parsed);
        var profile = earlier.With(
            result.Visualisation.Length.TotalMilliseconds, result.Spread.TotalMilliseconds, CalibrationMethod.Nudge, result.Count);
        var page = earlier.WithWarnings(NudgePage.Of(marks, result, profile));
        Shared.Finish(parsed, output, profile, page, () => NudgePage.Json(result));
        return ExitStatus.Done;
    }

    static Option<double[]> Offsets(string name, string direction) => NumberOption.CreateList(
        name, $"Offset along the motion at which hologram and robot coincided while moving {direction}; repeat the option for more measurements",
        -1000.0, 1000, "mm");
}
