using System.Diagnostics;
using Nowpose.Gateway.Messages;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Status.Events;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Tests how a gateway manages the adapters that it starts. The plant does not exist; its port is closed.</summary>
public class AdapterProcessTests : PlantFileFixture
{
    [TestCase(false)]
    [TestCase(true)]
    public async Task Start_PlantNotConnected_AdapterConnectsAsASourceAndReportsItsState(bool hasTokens)
    {
        await using var gateway = await Gateways.StartAsync(
            Gateways.Options() with { Tokens = hasTokens ? Gateways.Tokens : Nowpose.Gateway.Security.TokenList.None });
        var received = new TaskCompletionSource<DiagnosticsMessage>();
        using var listening = ListenTo(gateway, received);

        await using var adapters = AdapterProcesses.Start([Plant(Write(Good))], gateway);

        var diagnostics = await received.Task.Bounded();
        Assert.That(diagnostics.HardwareId, Is.EqualTo("plant/absent"));
        Assert.That(diagnostics.Values.Single(value => value.Key == "state").Value, Is.Not.EqualTo("connected"));
    }

    [Test]
    public async Task Run_AdapterKilled_IsRestartedWithAnEvent()
    {
        await using var gateway = await Gateways.StartAsync();
        var lines = new System.Collections.Concurrent.ConcurrentQueue<string>();
        await using var adapter = new AdapterProcess(Plant(Write(Good)), AdapterAccess.To(gateway), TimeProvider.System, lines.Enqueue);
        gateway.Expect([() => adapter.State]);
        await Soon.BecomesAsync(() => adapter.ProcessId != null && gateway.WebSocketConnections.Open == 1, "it is connected");

        var first = adapter.ProcessId;
        using (var process = Process.GetProcessById(first.Value)) process.Kill();

        var recovery = await Soon.BecomesAsync(() => adapter.ProcessId is { } second && second != first && gateway.WebSocketConnections.Accepted == 2, "the adapter is connected again");
        TestContext.Out.WriteLine($"there again after {recovery.TotalSeconds:0.0} s");
        Assert.That(lines, Has.Some.EndsWith(AdapterMessages.Ended("", "status 137", 0.5)));
        // On a busy machine, an earlier event states that the first program does not report yet.
        await Soon.BecomesAsync(() => EventOf(gateway, "status 137") is { Until: not null }, "it reports again");
        var ended = EventOf(gateway, "status 137").Condition;
        Assert.That(ended.Text, Is.EqualTo(
            $"adapter absent {EventTexts.DoesNotReport}: {EventTexts.StartedAgain(EventTexts.ProgramEnded("status 137"))}. {EventRemedies.GatewayLog}"));
        Assert.That((ended.Level, ended.Blocks), Is.EqualTo((Level.Error, true)));
    }

    [Test]
    public async Task Run_AdapterCannotStart_RaisesOneEventForAllAttempts()
    {
        await using var gateway = await Gateways.StartAsync();
        var lines = new System.Collections.Concurrent.ConcurrentQueue<string>();

        await using var adapter = new AdapterProcess(Plant(_folder.Path), AdapterAccess.To(gateway), TimeProvider.System, lines.Enqueue);
        gateway.Expect([() => adapter.State]);

        await Soon.BecomesAsync(() => lines.Count(line => line.Contains("its adapter ended", StringComparison.Ordinal)) >= 2, "it ended twice");
        await Soon.BecomesAsync(() => EventOf(gateway) != null, "the event has begun");
        Assert.That(EventOf(gateway).Until, Is.Null);
    }

    [Test]
    public async Task Start_AdapterEndsWhileTheLogIsRateLimited_GatewayLogsTheEnd()
    {
        var lines = new System.Collections.Concurrent.ConcurrentQueue<string>();
        await using var gateway = await GatewayServer.StartAsync(
            Gateways.Options(), new Nowpose.Gateway.Clock.StopwatchControlClock(Gateways.Start), lines.Enqueue).Bounded();
        for (var i = 0; i < 2 * RateLimitedLog.MaxKinds; i++) gateway.Log($"line {i}");

        await using var adapters = AdapterProcesses.Start([Plant(_folder.Path)], gateway);

        await Soon.BecomesAsync(() => lines.Any(line => line.Contains("its adapter ended", StringComparison.Ordinal)), "its end is logged");
        Assert.That(lines.Count(line => line.StartsWith("line ", StringComparison.Ordinal)), Is.EqualTo(RateLimitedLog.MaxKinds + RateLimitedLog.LinesAMinute));
    }

    [Test]
    public async Task Dispose_RunningAdapter_LeavesNoProcess()
    {
        await using var gateway = await Gateways.StartAsync();
        var adapter = new AdapterProcess(Plant(Write(Good)), AdapterAccess.To(gateway), TimeProvider.System, _ => { });
        await Soon.BecomesAsync(() => adapter.ProcessId != null, "it runs");
        using var process = Process.GetProcessById(adapter.ProcessId.Value);

        await adapter.DisposeAsync().AsTask().Bounded();

        Assert.That(process.HasExited, Is.True);
    }

    [Test]
    [Platform("Linux")]
    public async Task Serve_GatewayKilled_EndsItsAdapter()
    {
        var gateway = new PeerProcess("Nowpose.Gateway.dll", "serve", "--plant", Write(Good), "--sync-port", "0", "--ws-port", "0");
        await gateway.PrintsAsync("state serving");
        await Soon.BecomesAsync(() => ChildOf(gateway.Id) != null, "its adapter runs");
        using var child = Process.GetProcessById(ChildOf(gateway.Id).Value);

        // Kills only the gateway's process and not its child, like a crash.
        using (var itself = Process.GetProcessById(gateway.Id)) itself.Kill();

        Assert.That(child.WaitForExit(Soon.Limit), Is.True);
        gateway.Dispose();
    }

    static PlantFile Plant(string path) => new(path, "absent", "");

    static StatusEvent EventOf(GatewayServer gateway, string cause = "") => gateway.Events.Read().SingleOrDefault(
        one => one.Condition is { Kind: "adapter", What: EventTexts.DoesNotReport } && one.Condition.Text.Contains(cause, StringComparison.Ordinal));

    static IDisposable ListenTo(GatewayServer gateway, TaskCompletionSource<DiagnosticsMessage> received) =>
        gateway.Hub.Subscribe(RosTopics.Diagnostics, message =>
        {
            var text = System.Text.Encoding.UTF8.GetString(message.Utf8(RosTimeForm.Sec).Span);
            if (RosbridgeReader.TryRead(text, out var read, out _)) received.TrySetResult(read.Diagnostics);
        });

    // Returns the id of the first node process with this parent.
    static int? ChildOf(int parent) => Process.GetProcessesByName("node").FirstOrDefault(process => ParentOf(process.Id) == parent)?.Id;

    static int? ParentOf(int id)
    {
        try
        {
            // In this file, the state and the parent's id follow the name in brackets.
            var stat = File.ReadAllText($"/proc/{id}/stat");
            return int.Parse(stat[(stat.LastIndexOf(')') + 2)..].Split(' ')[1]);
        }
        catch (IOException)
        {
            return null;
        }
    }
}
