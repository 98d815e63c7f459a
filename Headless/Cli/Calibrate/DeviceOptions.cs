using System.CommandLine;
using Nowpose.Cli.Replay;
using Nowpose.Gateway.Options;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate;

/// <summary>What a profile says of the headset that was measured, for measurements that do not say it themselves.</summary>
sealed class DeviceOptions
{
    readonly Option<string> _device = new("--device")
    {
        Description = "The headset's model, as Unity's SystemInfo.deviceModel and the sweep's log have it; the headset refuses a profile of another "
            + "one. Not said: taken from the sweep's log, else the profile fits any",
        DefaultValueFactory = _ => "",
    };

    readonly Option<double> _displayHz = NumberOption.Create(
        "--display-hz", "Refresh rate of the headset's display; 0 for not said, as of --device", 0.0, 0, 1000, "Hz");

    public void AddTo(Command verb)
    {
        verb.Options.Add(_device);
        verb.Options.Add(_displayHz);
    }

    public string Device(ParseResult parsed) => parsed.GetValue(_device);

    public double DisplayHz(ParseResult parsed) => parsed.GetValue(_displayHz);

    /// <summary>Null where it was not typed: a log may know better.</summary>
    public string GivenDevice(ParseResult parsed) => RecordingOptions.IsGiven(parsed, _device) ? Device(parsed) : null;

    /// <summary>As <see cref="GivenDevice"/>.</summary>
    public double? GivenDisplayHz(ParseResult parsed) => RecordingOptions.IsGiven(parsed, _displayHz) ? DisplayHz(parsed) : null;

    /// <summary>The source of the render time, where a limit is found.</summary>
    public static Option<string> Source() => ChoiceOption.Create(
        "--source", "What render_ms was measured with; the limit holds for no other", RenderTimeSourceNames.NameOf(RenderTimeSourceKind.DisplayGpuTime),
        [.. Enum.GetValues<RenderTimeSourceKind>().Where(kind => kind != RenderTimeSourceKind.None).Select(RenderTimeSourceNames.NameOf)]);

    /// <param name="source">A choice of <see cref="Source"/>.</param>
    public static RenderTimeSourceKind KindOf(string source) =>
        RenderTimeSourceNames.TryParse(source, out var kind) ? kind : throw new InputException($"--source: '{source}' is not known");
}
