using System.Diagnostics;
using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Recording;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Recording;

/// <summary>Creates the parts of a gateway that a recorder needs, and a temporary folder for the recorder's files.</summary>
sealed class RecorderCell : IDisposable
{
    const double StepSeconds = 0.05;

    readonly List<string> _log = [];

    public RecorderCell()
    {
        Plant = new PlantClocks(null, new StopwatchHeadsetClock());
        Clock = new ServedClock(new StopwatchControlClock(Gateways.Start), Plant);
        Source = Hub.OpenSource();
    }

    public string Folder { get; } = Directory.CreateTempSubdirectory("nowpose-recordings-").FullName;
    public MessageHub Hub { get; } = new();
    public DropCounters Drops { get; } = new();
    public PlantClocks Plant { get; }
    public ServedClock Clock { get; }
    public HubSource Source { get; }

    public void Dispose()
    {
        Source.Dispose();
        Directory.Delete(Folder, true);
    }

    public Recorder Open(Func<string, LineFile> open = null, TimeProvider time = null, long maxBytes = RecordedFile.MaxBytes) => new(
        new GatewayOptions { Recordings = Folder, Cell = "press 1", Time = time ?? TimeProvider.System }, Hub, Clock, Plant, Drops,
        line => { lock (_log) _log.Add(line); }, open, maxBytes);

    /// <summary>Publishes samples as if they had arrived over the last few seconds. Each sample was 80 ms old on arrival.</summary>
    public void Publish(int count, params string[] names)
    {
        for (var i = 0; i < count; i++)
        {
            var ago = TimeSpan.FromSeconds((count - i) * StepSeconds);
            var received = Stopwatch.GetTimestamp() - (long)(ago.TotalSeconds * Stopwatch.Frequency);
            var position = 1.5 + 0.5 * Math.Sin(2 * Math.PI * 0.4 * i * StepSeconds);
            var stamp = Clock.Now - ago - TimeSpan.FromMilliseconds(80);
            Assert.That(Source.Publish(new JointStateMessage(stamp, names, [.. names.Select(_ => position)]), received), Is.Null);
        }
    }

    public string[] Files() => [.. Directory.GetFiles(Folder).Order(StringComparer.Ordinal)];

    public static JsonElement[] Lines(string path) => [.. File.ReadAllLines(path).Select(line => JsonDocument.Parse(line).RootElement)];

    public static int Count(IEnumerable<JsonElement> lines, string kind) => lines.Count(line => line.GetProperty("kind").GetString() == kind);

    public int CountLogged(string text)
    {
        lock (_log) return _log.Count(line => line.Contains(text));
    }
}
