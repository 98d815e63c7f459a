using System.Text.Json;

namespace Nowpose.Benchmarks.Links;

/// <summary>The frames and clock states of a headset's session file.</summary>
sealed class RecordedFrames
{
    readonly Dictionary<string, HeadsetTime> _clockStates = [];
    readonly List<Frame> _frames = [];

    public IReadOnlyList<Frame> All => _frames;

    /// <param name="Light">Estimated display time of the frame; null while the clock is unknown.</param>
    /// <param name="StatedError">Error of the clock as stated by the headset; null while the clock is unknown.</param>
    public sealed record Frame(
        HeadsetTime Start, ControlTime? Light, bool IsCurrent, double[] Joints, double[] Held, TimeSpan? StatedError);

    public static RecordedFrames Read(string path)
    {
        var session = new RecordedFrames();
        foreach (var text in File.ReadLines(path))
        {
            using var json = JsonDocument.Parse(text);
            session.Take(json.RootElement);
        }

        return session;
    }

    /// <summary>Gets the time at which the clock was in one of the given states for the first time; null if it never was.</summary>
    public HeadsetTime? FirstIn(params string[] states)
    {
        var times = states.Where(_clockStates.ContainsKey).Select(state => _clockStates[state]).ToList();
        return times.Count == 0 ? null : times.Min();
    }

    void Take(JsonElement line)
    {
        switch (line.GetProperty("kind").GetString())
        {
            case "frame": _frames.Add(FrameOf(line)); break;
            case "clock": _clockStates.TryAdd(line.GetProperty("state").GetString(), HeadsetTime.FromNanoseconds(Whole(line, "at_ns").Value)); break;
            case "lost": throw new InputException("lines are missing in the headset's session file, because the disk was too slow");
            default: break;
        }
    }

    static Frame FrameOf(JsonElement line) => new(
        HeadsetTime.FromNanoseconds(Whole(line, "start_ns").Value),
        Whole(line, "light_ns") is long light ? ControlTime.FromNanoseconds(light) : null,
        line.GetProperty("state").GetString() == "current", Numbers(line, "joints"), Numbers(line, "held"),
        Whole(line, "estimated_error_ns") is long error ? new TimeSpan(error / TimeSpan.NanosecondsPerTick) : null);

    static long? Whole(JsonElement line, string name) => line.TryGetProperty(name, out var value) ? value.GetInt64() : null;

    static double[] Numbers(JsonElement line, string name) =>
        [.. line.GetProperty(name).EnumerateArray().Select(value => value.ValueKind == JsonValueKind.Number ? value.GetDouble() : double.NaN)];
}
