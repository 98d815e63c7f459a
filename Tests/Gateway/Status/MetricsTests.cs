using System.Diagnostics;
using System.Text.Json.Nodes;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Nowpose.Gateway.Status;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Prometheus;
using YamlDotNet.Serialization;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Tests the metrics, and reads them with Prometheus's parser in Python if it is installed (Debian: python3-prometheus-client).</summary>
public class MetricsTests
{
    const string Python = "/usr/bin/python3";

    const string Parser = """
        import json, sys
        from prometheus_client.parser import text_string_to_metric_families
        families = list(text_string_to_metric_families(sys.stdin.read()))
        print(json.dumps([[f.type, f.documentation, [[s.name, s.labels, s.value] for s in f.samples]] for f in families]))
        """;

    static JsonObject Words(string name, params (string Key, object Value)[] words)
    {
        var all = new JsonObject { ["name"] = name, ["seen_s_ago"] = 0.5 };
        foreach (var (key, value) in words) all[key] = value is double number ? number : (string)value;
        return all;
    }

    static StatusSnapshot Snapshot(params JsonObject[] headsets) => new()
    {
        Cell = "press",
        Host = "cell-pc",
        Version = "1.2.3",
        Status = new OverallStatus("ok", "fine"),
        StartedUtc = "2026-11-20T12:00:00Z",
        UptimeS = 5,
        ControlTimeS = 100,
        Clock = new ClockStatus("own", "synchronised", true, 120, 3, 0.5, 1000, 2),
        PlantClocks = [new PlantClockView("press", true, true, "synchronised", null, 4.2, 1.5, 200, 1000, 40, 2, "no response within 2 s")],
        Adapters = [Words("press", ("state", "connected"), ("samples", 12.0), ("refused", 9.0), ("refused/bad_status", 7.0), ("refused/nan", 2.0))],
        Sources = [new SourceStatus(["a", "b"], 49.9, new AgeStatus(80, 120), ["b"])],
        Joints =
        [
            new JointView("a", "press", "live", "2026-11-20T12:00:00.000Z", 0.08, 49.9, ""),
            new JointView("b", "press", "refused", "2026-11-20T12:00:01.000Z", null, 0, "status Bad", ReasonWord: "status-bad"),
        ],
        Frames = [new FrameView("box", "world", "press", "live", 0.1)],
        Signals = [new SignalView("grip", 1, "press", "live", 2)],
        Headsets = headsets,
        ForwardMs = new SpanStatus(0.2, 0.9),
        Connections = new Dictionary<string, ConnectionStatus> { ["sync"] = new(2, 5, new Dictionary<string, long> { ["Silence"] = 3 }) },
        Messages = new Dictionary<string, long> { ["/joint_states"] = 77 },
        Drops = new Dictionary<string, long> { ["NotJson"] = 4 },
        Recording = new RecordingStatus(true, true, "x.jsonl", 10, 2000, 1, null),
        PairsHeadsets = false,
        IsReady = true,
        Events = [new EventView(1, "joint", "b (press)", "is refused", "status Bad", "error", "2026-11-20T12:00:01.000Z", null)],
    };

    static JsonNode Parse(string text)
    {
        Needs.Program(File.Exists(Python), "python3");
        var start = new ProcessStartInfo(Python) { RedirectStandardInput = true, RedirectStandardOutput = true, RedirectStandardError = true };
        start.ArgumentList.Add("-c");
        start.ArgumentList.Add(Parser);
        using var process = Process.Start(start);
        var errors = process.StandardError.ReadToEndAsync();
        process.StandardInput.Write(text);
        process.StandardInput.Close();
        var output = process.StandardOutput.ReadToEnd();
        Assert.That(process.WaitForExit(Soon.Limit), Is.True);
        Needs.Program(!errors.Result.Contains("No module named 'prometheus_client'"), "python3-prometheus-client");
        Assert.That(process.ExitCode, Is.EqualTo(0), errors.Result);
        return JsonNode.Parse(output);
    }

    static double Value(JsonNode families, string name, string label = null) => (double)families.AsArray()
        .SelectMany(family => family[2].AsArray())
        .Single(sample => (string)sample[0] == name && (label == null || sample[1].AsObject().Any(pair => (string)pair.Value == label)))[2];

    [Test]
    public void Of_Snapshot_CanBeParsedByPrometheus()
    {
        var times = new ForwardingTimes();
        times.Add(TimeSpan.FromMilliseconds(3));
        times.Add(TimeSpan.FromMilliseconds(30));

        var families = Parse(Metrics.Of(Snapshot(Words("goggles", ("state", "holdover"), ("l_app_ms", 95.0))), times));

        Assert.That(Value(families, "nowpose_clock_error_bound_seconds"), Is.EqualTo(120e-6).Within(1e-12));
        Assert.That(Value(families, "nowpose_joint_state_since_seconds", "b"), Is.EqualTo(1_795_176_001));
        Assert.That(Value(families, "nowpose_clock_skew_ratio"), Is.EqualTo(3e-6).Within(1e-12));
        foreach (var name in new[] { "nowpose_plant_clock_skew_ratio", "nowpose_plant_clock_drift_ratio" })
            Assert.That(Value(families, name, "press"), Is.EqualTo(4.2e-6).Within(1e-12), name);
        Assert.That(Value(families, "nowpose_plant_clock_round_trip_seconds", "press"), Is.EqualTo(1.5e-3).Within(1e-12));
        Assert.That(Value(families, "nowpose_adapter_connected", "press"), Is.EqualTo(1));
        Assert.That(Value(families, "nowpose_source_age_seconds", "0.95"), Is.EqualTo(0.12).Within(1e-12));
        Assert.That(Value(families, "nowpose_forward_seconds_bucket", "0.005"), Is.EqualTo(1));
        Assert.That(Value(families, "nowpose_forward_seconds_bucket", "+Inf"), Is.EqualTo(2));
        Assert.That(Value(families, "nowpose_forward_seconds_sum"), Is.EqualTo(0.033).Within(1e-9));
        Assert.That(Value(families, "nowpose_headset_synchronised", "goggles"), Is.EqualTo(0));
        Assert.That(Value(families, "nowpose_headset_application_latency_seconds", "goggles"), Is.EqualTo(0.095).Within(1e-12));
        Assert.That(Value(families, "nowpose_connections_closed_total", "Silence"), Is.EqualTo(3));
        Assert.That(Value(families, "nowpose_recording_lost_lines"), Is.EqualTo(1));
        Assert.That(Value(families, "nowpose_source_beyond_limits"), Is.EqualTo(1));
        Assert.That(Value(families, "nowpose_adapter_refusals_total", "bad_status"), Is.EqualTo(7));
        Assert.That(Value(families, "nowpose_events_active", "joint"), Is.EqualTo(1));
        foreach (var family in families.AsArray())
        {
            Assert.That((string)family[0], Is.Not.EqualTo("unknown").And.Not.EqualTo("untyped"), family.ToJsonString());
            Assert.That((string)family[1], Is.Not.Empty, family.ToJsonString());
        }
    }

    [Test]
    public void Of_AdapterAndHeadsetAreSilent_LastReportDoesNotCountAsTheirPresentState()
    {
        var state = Snapshot(Words("goggles", ("seen_s_ago", 8.0), ("state", "synchronised"), ("pose", "current"), ("rtt_ms", 3.0))) with
        {
            Adapters = [Words("press", ("seen_s_ago", 8.0), ("state", "connected"), ("samples", 12.0))],
        };

        var lines = Metrics.Of(state, new ForwardingTimes()).Split('\n');

        Assert.That(lines, Has.Member("nowpose_adapter_connected{adapter=\"press\"} 0"));
        Assert.That(
            lines.Where(line => line.Contains("goggles", StringComparison.Ordinal)),
            Is.EqualTo(new[] { "nowpose_headset_seen_seconds{headset=\"goggles\"} 8" }));
    }

    [Test]
    public void Of_Joint_MetricIsOneOnlyForItsCurrentState()
    {
        var lines = Metrics.Of(Snapshot(), new ForwardingTimes()).Split('\n').Where(line => line.StartsWith("nowpose_joint_state{", StringComparison.Ordinal)).ToList();

        Assert.That(lines, Has.Count.EqualTo(2 * 6));
        Assert.That(lines.Where(line => line.EndsWith(" 1", StringComparison.Ordinal)), Is.EqualTo(new[]
        {
            "nowpose_joint_state{joint=\"a\",source=\"press\",state=\"live\"} 1", "nowpose_joint_state{joint=\"b\",source=\"press\",state=\"refused\"} 1",
        }));
    }

    [Test]
    public void Of_FrameAndSignal_MetricIsOneOnlyForTheirCurrentState()
    {
        var state = Snapshot() with
        {
            Frames = [new FrameView("box", "nowhere", "twin", "orphan", 0.1), new FrameView("table", "world", "twin", "stationary", null)],
            Signals = [new SignalView("grip", 1, "plc", "ended", 2)],
        };

        var lines = Metrics.Of(state, new ForwardingTimes()).Split('\n').Where(line => Regex.IsMatch(line, "^nowpose_(frame|signal)_state{")).ToList();

        Assert.That(lines, Has.Count.EqualTo(2 * 8 + 6));
        Assert.That(lines.Where(line => line.EndsWith(" 1", StringComparison.Ordinal)), Is.EqualTo(new[]
        {
            "nowpose_frame_state{frame=\"box\",source=\"twin\",state=\"orphan\"} 1", "nowpose_frame_state{frame=\"table\",source=\"twin\",state=\"stationary\"} 1",
            "nowpose_signal_state{signal=\"grip\",source=\"plc\",state=\"ended\"} 1",
        }));
    }

    [Test]
    public void Of_ManyReportedFrames_IsBounded()
    {
        var reported = Enumerable.Range(0, 1000).Select(i => new FrameView($"lid{i}", null, "twin", "missing", null));
        var state = Snapshot() with { Frames = [.. reported, new FrameView("box", "world", "twin", "live", 0.1)] };

        var lines = Metrics.Of(state, new ForwardingTimes()).Split('\n').Where(line => line.StartsWith("nowpose_frame_state{", StringComparison.Ordinal)).ToList();

        Assert.That(lines, Has.Count.EqualTo(8 * 257).And.Some.Contains("frame=\"box\""));
    }

    [TestCase("status-bad", "status-bad")]
    [TestCase("node-gone", "node-gone")]
    [TestCase("a word of a later release", "other")]
    public void Of_JointInFault_NamesTheReasonWithAKnownWord(string word, string expected)
    {
        var state = Snapshot();
        state = state with { Joints = [state.Joints[0], state.Joints[1] with { ReasonWord = word }] };

        var lines = Metrics.Of(state, new ForwardingTimes()).Split('\n').Where(line => line.StartsWith("nowpose_joint_fault{", StringComparison.Ordinal));

        Assert.That(lines, Is.EqualTo(new[] { $"nowpose_joint_fault{{joint=\"b\",source=\"press\",reason=\"{expected}\"}} 1" }));
    }

    [TestCase("unsynchronised", 0, "unsynchronised")]
    [TestCase("converging", 0, "converging")]
    [TestCase("coarse", 0, "coarse")]
    [TestCase("synchronised", 1, "synchronised")]
    [TestCase("holdover", 0, "holdover")]
    [TestCase("invented", 0, "other")]
    public void Of_ClockStateOfAHeadset_IsSynchronisedOnlyInTheStateSynchronised(string state, int synchronised, string expected)
    {
        var lines = Metrics.Of(Snapshot(Words("goggles", ("state", state))), new ForwardingTimes()).Split('\n');

        Assert.That(lines, Does.Contain($"nowpose_headset_synchronised{{headset=\"goggles\"}} {synchronised}"));
        Assert.That(
            lines.Where(line => line.StartsWith("nowpose_headset_clock_state{", StringComparison.Ordinal) && line.EndsWith(" 1", StringComparison.Ordinal)),
            Is.EqualTo(new[] { $"nowpose_headset_clock_state{{headset=\"goggles\",state=\"{expected}\"}} 1" }));
    }

    [Test]
    public void Of_JointAtRest_ContainsItsUncertainty()
    {
        JointView Rest(string name, string uncertain) => new(name, "press", "rest", "2026-11-20T12:00:00.000Z", 5, 0, "no change is reported", uncertain);
        var state = Snapshot() with { Joints = [Rest("sure", null), Rest("doubtful", "the stop itself was not observed")] };

        var lines = Metrics.Of(state, new ForwardingTimes()).Split('\n').Where(line => line.StartsWith("nowpose_joint_rest_uncertain{", StringComparison.Ordinal));

        Assert.That(lines, Is.EqualTo(new[]
        {
            "nowpose_joint_rest_uncertain{joint=\"sure\",source=\"press\"} 0", "nowpose_joint_rest_uncertain{joint=\"doubtful\",source=\"press\"} 1",
        }));
    }

    [TestCase("held", "held")]
    [TestCase("coarse", "coarse")]
    [TestCase("a word of a later release", "other")]
    public void Of_PoseStateOfAHeadset_IsAKnownStateOrOther(string pose, string expected)
    {
        var text = Metrics.Of(Snapshot(Words("goggles", ("pose", pose), ("missing_joints", "a,b"), ("current_share", 0.25), ("objects_not_current", 3.0))), new ForwardingTimes());

        Assert.That(text, Does.Contain($"nowpose_headset_pose_state{{headset=\"goggles\",state=\"{expected}\"}} 1"));
        Assert.That(text.Split('\n').Count(line => line.StartsWith("nowpose_headset_pose_state{", StringComparison.Ordinal)), Is.EqualTo(7));
        Assert.That(text, Does.Contain("nowpose_headset_current_share_ratio{headset=\"goggles\"} 0.25"));
        Assert.That(text, Does.Contain("nowpose_headset_missing_joints{headset=\"goggles\"} 2"));
        Assert.That(text, Does.Contain("nowpose_headset_objects_not_current{headset=\"goggles\"} 3").And.Not.Contain("nowpose_headset_signals_not_current{"));
    }

    [Test]
    public void AlertRules_OfTheExample_UseExistingMetricsAndStates()
    {
        var rules = new DeserializerBuilder().Build().Deserialize<Dictionary<string, object>>(RepositoryFiles.Read("Gateway/Packaging/nowpose-alerts.yaml"));
        var group = (Dictionary<object, object>)((List<object>)rules["groups"]).Single();
        var expressions = ((List<object>)group["rules"]).Cast<Dictionary<object, object>>().Select(rule =>
        {
            Assert.That(rule.Keys, Does.Contain("alert").And.Contain("expr").And.Contain("annotations"));
            return (string)rule["expr"];
        }).ToList();

        var state = Snapshot(Words("goggles", ("pose", "held"))) with { CertificateExpiresUtc = DateTime.UnixEpoch };
        var written = Metrics.Of(state, new ForwardingTimes());
        var texts = ((List<object>)group["rules"]).Cast<Dictionary<object, object>>()
            .SelectMany(rule => ((Dictionary<object, object>)rule["annotations"]).Values.Cast<string>()).ToList();
        foreach (var name in expressions.Concat(texts).SelectMany(text => Regex.Matches(text, @"nowpose_\w+").Select(match => match.Value)))
            Assert.That(written, Does.Contain($"# TYPE {name} "), name);
        foreach (var word in expressions.SelectMany(expression => Regex.Matches(expression, "state=~\"([a-z|]+)\"").SelectMany(match => match.Groups[1].Value.Split('|'))))
            Assert.That(written, Does.Contain($"state=\"{word}\""), word);
        Assert.That(expressions, Has.Count.GreaterThan(4));
        Assert.That(texts, Has.Some.Contains("nowpose_joint_fault{"), "the alert about a joint has the reason");
    }

    [Test]
    public void Of_SourceNamesWithCommaOrInvalidUtf8_HaveUniqueLabels()
    {
        string[][] sources = [["a,b"], ["a", "b"], ["a\\", "b"], ["\ud800"], ["\ud801"]];
        var state = Snapshot() with { Sources = [.. sources.Select(names => new SourceStatus(names, 50, new AgeStatus(80, 120), []))] };

        var text = Metrics.Of(state, new ForwardingTimes());

        var rates = text.Split('\n').Where(line => line.StartsWith("nowpose_source_rate_hertz{", StringComparison.Ordinal)).ToList();
        Assert.That(rates, Is.Unique.And.Count.EqualTo(4), text);
        Assert.That(text.Split('\n').Where(line => line.Length > 0 && line[0] != '#').Select(line => line[..line.LastIndexOf(' ')]), Is.Unique);
    }

    [Test]
    public void Of_Certificate_ContainsItsExpiryTime()
    {
        var text = Metrics.Of(Snapshot() with { CertificateExpiresUtc = new DateTime(2027, 1, 1, 0, 0, 0, DateTimeKind.Utc) }, new ForwardingTimes());

        Assert.That(text, Does.Contain("\nnowpose_certificate_expiry_timestamp_seconds 1798761600\n"));
        Assert.That(Metrics.Of(Snapshot(), new ForwardingTimes()), Does.Not.Contain("certificate"));
    }

    [Test]
    public void Of_NonFiniteNumbers_AreOmitted()
    {
        var state = Snapshot() with { Sources = [new SourceStatus(["a"], double.PositiveInfinity, new AgeStatus(double.NaN, 120), [])] };

        var text = Metrics.Of(state, new ForwardingTimes());

        Assert.That(text, Does.Not.Contain("Infinity").And.Not.Contain("NaN").And.Not.Contain("∞"));
        Assert.That(text, Does.Contain("nowpose_source_age_seconds{joints=\"a\",quantile=\"0.95\"} 0.12"));
    }

    [TestCase("quote \" backslash \\ line\nfeed \\n")]
    [TestCase("} 1\nevil_metric 1")]
    [TestCase("\r\u2028 \u0085 ünïcode 头")]
    public void Of_HeadsetNameWithSpecialCharacters_KeepsTheWholeNameInOneLine(string name)
    {
        var families = Parse(Metrics.Of(Snapshot(Words(name, ("state", "synchronised"))), new ForwardingTimes()));

        Assert.That(Value(families, "nowpose_headset_synchronised", InputException.OneLine(name, int.MaxValue)), Is.EqualTo(1));
        Assert.That(families.ToJsonString(), Does.Not.Contain("\"evil_metric\""));
    }
}
