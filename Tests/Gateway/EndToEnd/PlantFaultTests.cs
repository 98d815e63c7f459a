using System.Diagnostics;
using System.Globalization;
using System.Text.Json;
using System.Text.RegularExpressions;
using Nowpose.Gateway.Messages;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.EndToEnd.ShownStatus;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>
/// Runs an OPC UA server, the gateway with its adapter, and a headset as processes. Tests how they report a joint whose data stop and a
/// robot at rest.
/// </summary>
public class PlantFaultTests
{
    const string Joint = "arm_joint_3";

    /// <summary>Documented maximum time until a fault is reported. Excludes time during which a task waited for a processor.</summary>
    static readonly TimeSpan Promise = TimeSpan.FromSeconds(2);

    /// <summary>Maximum time with the time in which tasks wait for a processor, which is nearly the whole time on a busy machine.</summary>
    static readonly TimeSpan Limit = TimeSpan.FromSeconds(15);

    /// <summary>Time between two readings of the status, ms. Each reading sends three requests, which take more processor time than the plant.</summary>
    const int ReadingIntervalMs = 50;

    TemporaryFolder _folder;
    MovingPlant _plant;
    PeerProcess _gateway;
    HttpClient _http;
    HeardDiagnostics _diagnostics;

    [OneTimeSetUp]
    public async Task Start()
    {
        _folder = new TemporaryFolder();
        _plant = await MovingPlant.StartAsync("opcua");
        _gateway = new PeerProcess("Nowpose.Gateway.dll", "serve", "--plant", _plant.Configure(_folder.Path), "--sync-port", "0", "--ws-port", "0");
        await _gateway.PrintsAsync("state serving");
        _http = new HttpClient { BaseAddress = new Uri(_gateway.ValueOf("websocket").Replace("ws://", "http://")) };
        _diagnostics = await HeardDiagnostics.StartAsync(new Uri(_gateway.ValueOf("websocket")));
    }

    [OneTimeTearDown]
    public void Stop()
    {
        _diagnostics?.Dispose();
        _http?.Dispose();
        _gateway?.Dispose();
        _plant?.Dispose();
        _folder?.Dispose();
    }

    [TearDown]
    public Task Repair() => _plant.CommandAsync("repair", Joint);

    // One case for each state. Tests of the adapter cause all faults at the same server.
    [TestCase("stop", "fault", "ended in mid-motion", "ended-in-motion")]
    [TestCase("bad", "refused", "BadSensorFailure", "status-bad")]
    public async Task Joint_FaultAtTheServer_IsReportedEverywhereUntilRepaired(string fault, string state, string reason, string word)
    {
        using var before = StartHeadset();
        await GoodEverywhereAsync(DateTimeOffset.UtcNow);
        // The adapter recognises the end of data in mid-motion by the decelerations that it has observed.
        await GoodEverywhereAsync(await _plant.CommandAsync("rest", "500"));

        var lastEvent = LastEvent(await ReadAsync());
        var begun = await _plant.CommandAsync(fault, Joint);
        var named = await EverywhereAsync(begun, (status, place) => status.Reports(place, Joint, state, reason, word), $"{Joint} {state}");
        // On a busy machine, the values of other joints may be delayed for a moment.
        var during = default(ShownStatus);
        await Soon.BecomesAsync(
            () => (during = ReadAsync().GetAwaiter().GetResult()).AreOthersLive(Joint), () => $"the other joints go on; {during}", ReadingIntervalMs);
        // A busy machine may have delayed all samples before the fault, which is another outage.
        await Soon.BecomesAsync(
            () => before.Lines.Any(line => line.Contains("the pose is ") && line.Contains(reason)), () => $"an outage: {reason}; {before.All}");
        var seen = await ResultOfAsync(before);
        using var after = StartHeadset();
        var status = default(ShownStatus);
        await Soon.BecomesAsync(
            () => (status = ReadAsync().GetAwaiter().GetResult()).IsHeadsetWithout(Joint), () => $"a headset without {Joint}; {status}", ReadingIntervalMs);
        var repaired = await _plant.CommandAsync("repair", Joint);
        var good = await GoodEverywhereAsync(repaired);
        var end = await ReadAsync();
        var recovered = await ResultOfAsync(after);

        TestContext.Out.WriteLine($"{fault}: named after {Words(named)}; good again after {Words(good)}");
        Assert.That(named.Values, Is.Not.Empty.And.All.Matches<Delay>(delay => delay.IsKept));
        Assert.That(good.Values, Is.All.Matches<Delay>(delay => delay.IsKept));
        Assert.That(during.Joints.Count(), Is.EqualTo(7));
        Assert.That(Text(seen.GetProperty("pose"), "state"), Is.AnyOf("held", "unsynchronised"), "unsynchronised only on a busy machine");
        // A busy machine may delay the samples of the other joints during the same outage.
        Assert.That(Names(seen, "missing_joints"), Does.Contain(Joint), seen.ToString());
        var reported = seen.GetProperty("joints").EnumerateArray().Single(joint => Text(joint, "name") == Joint);
        Assert.That(Text(reported, "state"), Is.EqualTo(state));
        Assert.That(Text(reported, "reason"), Does.Match(reason));
        Assert.That(seen.GetProperty("outages").EnumerateArray(), Has.Some.Matches<JsonElement>(
            outage => Names(outage, "joints").Contains(Joint) && Regex.IsMatch(Text(outage, "reason"), reason)), "outages: " + seen);
        // On a busy machine the pose of the last frame may not be current, so any stretch with a current pose is sufficient. The headset started
        // during the fault, so all stretches are after the repair.
        Assert.That(recovered.GetProperty("stretches").EnumerateArray(), Is.Not.Empty, recovered.ToString());
        // A busy machine may delay the samples of any joint, which is then reported as stale.
        var events = EventsAfter(lastEvent, end).Where(one => Text(one, "what") != EventTexts.Is("stale")).ToList();
        Assert.That(events.Select(one => Text(one, "which")), Is.All.EqualTo($"{Joint} (plc)"), string.Join("\n", events));
        Assert.That(events, Is.Not.Empty);
        Assert.That(
            events.Select(one => DateTimeOffset.Parse(Text(one, "until_utc"), CultureInfo.InvariantCulture)), Is.All.LessThan(repaired + good.Values.Max(delay => delay.Length) + Limit));
    }

    [Test]
    public async Task Robot_RestsAndMovesAgain_IsNotReportedAsAFaultAnywhere()
    {
        using var headset = StartHeadset();
        await GoodEverywhereAsync(DateTimeOffset.UtcNow);

        // A busy machine may delay samples until joints are stale, or until the headset holds its pose. Then the robot rests once more.
        var fault = "";
        for (var since = Stopwatch.StartNew(); fault != null && since.Elapsed < Soon.Limit;) fault = await FaultOfRestAsync();

        var result = await ResultOfAsync(headset);
        TestContext.Out.WriteLine($"rest: pose current for {result.GetProperty("pose").GetProperty("current_share")} of the frames, {result.GetProperty("frames")} frames");
        Assert.That(fault, Is.Null);
    }

    /// <summary>Makes the robot rest and move again.</summary>
    /// <returns>Null if all places report the rest, and none of them a fault; otherwise the state that shows the contrary.</returns>
    async Task<string> FaultOfRestAsync()
    {
        var states = new HashSet<string>();
        var shown = await ReadAsync();
        var (lastEvent, isGoodAtRest, isFaultless) = (LastEvent(shown), false, true);
        for (var rest = _plant.CommandAsync("rest", "3000"); !rest.IsCompletedSuccessfully || shown.AreAll("live") is false; await Task.Delay(ReadingIntervalMs))
        {
            if (rest.IsFaulted) await rest;
            shown = await ReadAsync();
            states.UnionWith(shown.Joints.Select(joint => Text(joint, "state")));
            isGoodAtRest |= shown.AreAll("rest") && Places.All(shown.IsGood);
            isFaultless &= Places.Except(["page", "headset"]).All(shown.IsGood);
        }

        var isReported = states.SetEquals(["live", "rest"]) && isGoodAtRest && isFaultless && EventsAfter(lastEvent, shown).Count == 0;
        return isReported ? null : $"states {string.Join(", ", states)}; {shown}";
    }

    Task<ShownStatus> ReadAsync() => ShownStatus.ReadAsync(_http, _diagnostics);

    PeerProcess StartHeadset()
    {
        _diagnostics.Forget("headless");
        return new PeerProcess(
            "Nowpose.Cli.dll", "headset", "--sync-port", _gateway.ValueOf("sync").Split(':')[1],
            "--ws-port", _http.BaseAddress.Port.ToString(CultureInfo.InvariantCulture), "--seconds", "600", "--json");
    }

    static async Task<JsonElement> ResultOfAsync(PeerProcess headset)
    {
        Assert.That(await headset.InterruptAsync(), Is.EqualTo(130), headset.All);
        return JsonDocument.Parse(string.Join('\n', headset.Lines.Where(line => Regex.IsMatch(line, "^[ {}]")))).RootElement;
    }

    static IEnumerable<string> Names(JsonElement result, string key) => result.GetProperty(key).EnumerateArray().Select(joint => joint.GetString());

    Task<Dictionary<string, Delay>> GoodEverywhereAsync(DateTimeOffset since) => EverywhereAsync(since, (status, place) => status.IsGood(place), "all good");

    /// <summary>Waits until all places report a condition at the same time.</summary>
    /// <returns>Time from <paramref name="since"/> until each place first reported the condition.</returns>
    async Task<Dictionary<string, Delay>> EverywhereAsync(DateTimeOffset since, Func<ShownStatus, string, bool> shows, string what)
    {
        var first = new Dictionary<string, Delay>();
        // Only the time until here depends on a clock that can be set.
        var (waited, before, start) = (ProcessorPressure.Waited(), DateTimeOffset.UtcNow - since, Stopwatch.GetTimestamp());
        var status = default(ShownStatus);
        await Soon.BecomesAsync(
            () =>
            {
                status = ReadAsync().GetAwaiter().GetResult();
                var showing = Places.Where(place => shows(status, place)).ToList();
                foreach (var place in showing) first.TryAdd(place, new Delay(before + Stopwatch.GetElapsedTime(start), ProcessorPressure.Waited() - waited));
                return showing.Count == Places.Count;
            },
            () => $"{what}; only {string.Join(", ", first.Keys)}; {status}\n{_gateway.All}", ReadingIntervalMs);
        return first;
    }

    static long LastEvent(ShownStatus status) => status.Events.Select(one => one.GetProperty("id").GetInt64()).DefaultIfEmpty().Max();

    // Without the events of headsets, and of the clock, whose exchanges a busy machine may delay.
    static List<JsonElement> EventsAfter(long lastEvent, ShownStatus status) =>
        [.. status.Events.Where(one => one.GetProperty("id").GetInt64() > lastEvent && Text(one, "kind") is not ("headset" or "clock"))];

    static string Words(Dictionary<string, Delay> delays) => string.Join(", ", delays.Select(pair => $"{pair.Key} {pair.Value}"));

    /// <param name="Length">Time from the fault or the repair until a place reported it.</param>
    /// <param name="Waited">Part of <paramref name="Length"/> in which a task waited for a processor; null if unknown.</param>
    readonly record struct Delay(TimeSpan Length, TimeSpan? Waited)
    {
        // A tenth of the waiting time is added, because the caches of a busy processor are cold.
        public bool IsKept => Length < Limit && (Waited is not { } waited || Length - waited < Promise + waited / 10);

        public override string ToString() =>
            string.Create(CultureInfo.InvariantCulture, $"{Length.TotalSeconds:0.00} s ({Waited?.TotalSeconds:0.00} s of it with busy processors)");
    }
}
