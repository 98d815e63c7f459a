using System.CommandLine;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Options;
using Nowpose.Latency.Conditions;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>calibrate range FILE.csv</c>: finds the constant-latency range from pairs of render time and L_visu.</summary>
static class RangeVerb
{
    public static Command Create()
    {
        var file = new Argument<string>("FILE") { Description = "Pairs: columns render_ms and visu_ms, optionally vertices; .csv or .csv.gz." };
        var device = new DeviceOptions();
        var source = DeviceOptions.Source();
        var output = OutOption.Create();
        var json = OutOption.Json();
        var verb = new Command("range", "Estimate L_visu and the render time up to which it is constant.") { file, source, output, json };
        device.AddTo(verb);
        verb.SetAction(parsed => Run(
            parsed.GetValue(file), parsed.GetValue(source), device.Conditions(parsed), parsed.GetValue(output), parsed.GetValue(json)));
        return verb;
    }

    static int Run(string file, string source, DisplayConditions conditions, string folder, bool asJson)
    {
        var pictures = PairTable.Read(file);
        var kind = DeviceOptions.KindOf(source);
        RequireRise(pictures, file, source);
        var fit = FitOf(pictures, file);
        var output = CalibrationOutput.At(folder);
        var profile = RangeProfile.Of(fit, conditions, kind);
        var page = RangeProfile.Page("Constant-latency range", profile, fit, pictures, [["Pairs of", file]]);
        var written = output.Write(profile, page);
        CalibrationTable.Print(page, written, output.PagePath, asJson ? RangeJson.Of(fit) : null);
        return ExitStatus.Done;
    }

    // Throws if the render time does not increase with the load, because no limit can then be found or monitored. Skipped for fewer than three loads.
    static void RequireRise(IReadOnlyList<MeasuredPicture> pictures, string file, string source)
    {
        const double MinRise = 0.1;
        var loads = pictures.Where(each => each.Vertices.HasValue).GroupBy(each => each.Vertices.Value).OrderBy(load => load.Key)
            .Select(load => Quantile.Of(load.Select(each => each.RenderMs.Value), 0.5)).ToArray();
        var third = loads.Length / 3;
        if (third == 0) return;
        double low = loads[..third].Average(), high = loads[^third..].Average();
        if (high - low >= MinRise * low) return;
        throw new InputException(RangeMessages.SourceDoesNotRespond(file, source, low, high));
    }

    static RangeFitResult FitOf(IReadOnlyList<MeasuredPicture> pictures, string file)
    {
        try
        {
            return RangeFit.Fit([.. pictures.Select(each => new LatencyPair(each.RenderMs.Value, each.VisuMs))]);
        }
        catch (InputException bad)
        {
            throw new InputException($"{file}: {bad.Message}");
        }
    }
}
