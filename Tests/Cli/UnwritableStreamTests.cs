using System.Globalization;
using Nowpose.Cli.Messages;
using Nowpose.Headless.Tests.Gateway;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Programs whose standard streams are closed or lead to a full disk.</summary>
[Platform("Linux")]
public class UnwritableStreamTests
{
    // The second exchange is dropped, which the command reports on stderr.
    const string Log = "t1_ns,t2_ns,t3_ns,t4_ns\n0,500000,500000,1000000\n1000000000,1000500000,1000400000,1001000000\n";

    const int LongLogRows = 4000;

    // The result is longer than a pipe holds.
    static string LongLog => "t1_ns,t2_ns,t3_ns,t4_ns\n" + string.Concat(Enumerable.Range(0, LongLogRows).Select(i =>
        FormattableString.Invariant($"{i}000000000,{i}000500000,{i}000500000,{i}001000000\n")));

    const string Urdf = """
        <robot name="r"><link name="base"/><link name="a"/>
        <joint name="q" type="prismatic"><parent link="base"/><child link="a"/><limit lower="0" upper="0.5"/></joint></robot>
        """;

    [TestCase("2>/dev/full")]
    [TestCase("2>&-")]
    public async Task Sync_UnwritableErrors_WritesTheResult(string redirection)
    {
        using var log = new TemporaryFile(Log);
        using var program = Cli($"sync '{log.Path}' {redirection}");

        Assert.That(await program.EndsAsync(), Is.EqualTo(0), program.All);
        Assert.That(program.Lines, Has.Count.EqualTo(3));
    }

    [TestCase("2>/dev/full")]
    [TestCase("2>&-")]
    public async Task Kinematics_UnwritableErrors_WritesTheResult(string redirection)
    {
        using var urdf = new TemporaryFile(Urdf, ".urdf");
        using var program = Cli($"kinematics '{urdf.Path}' --joints q=9 --json {redirection}");

        Assert.That(await program.EndsAsync(), Is.EqualTo(0), program.All);
        Assert.That(program.All, Does.StartWith("{"));
    }

    [TestCase(">/dev/full")]
    [TestCase(">&-")]
    public async Task Sync_UnwritableOutput_NamesTheStream(string redirection)
    {
        using var log = new TemporaryFile(Log);
        using var program = Cli($"sync '{log.Path}' {redirection}");

        Assert.That(await program.EndsAsync(), Is.EqualTo(1));
        Assert.That(program.Lines.Last(), Does.StartWith(ConsoleMessages.Line("standard output: ")));
    }

    [Test]
    public async Task Sync_NonBlockingPipe_WaitsForItsReader()
    {
        using var log = new TemporaryFile(LongLog);
        var cli = $"dotnet '{Path.Combine(AppContext.BaseDirectory, "Nowpose.Cli.dll")}'";
        // The reader starts another program after the first byte, so that the pipe is full in the meantime.
        using var program = PeerProcess.OfShell(
            $"{{ python3 -c 'import os; os.set_blocking(1, False)'; {cli} sync '{log.Path}'; echo status $? >&2; }} "
            + $"| {{ dd bs=1 count=1 2>/dev/null; {cli} --version >/dev/null; cat; }} | wc -l");

        await program.EndsAsync();

        Assert.That(program.Lines, Does.Contain("status 0").And.Contain((1 + LongLogRows).ToString(CultureInfo.InvariantCulture)), program.All);
    }

    [Test]
    public async Task Sync_ReaderOfThePipeHasEnded_EndsWithoutAMessage()
    {
        using var log = new TemporaryFile(LongLog);
        using var program = PeerProcess.OfShell(
            $"{{ dotnet '{Path.Combine(AppContext.BaseDirectory, "Nowpose.Cli.dll")}' sync '{log.Path}'; echo status $? >&2; }} | head -n 1");

        await program.EndsAsync();

        Assert.That(program.Lines.Where(line => !line.EndsWith(" estimates", StringComparison.Ordinal)),
            Is.EquivalentTo(new[] { "t4_ns,offset_ns,skew_ppm,error_bound_ns,state,estimated_error_ns", "status 1" }));
    }

    [Test]
    public async Task Replay_FullDisk_IsAFailedRun()
    {
        using var motion = new TemporaryFile("t,a\n0,0\n1,1\n2,0\n");
        using var program = Cli($"replay '{motion.Path}' --frames /dev/full");

        Assert.That(await program.EndsAsync(), Is.EqualTo(1), program.All);
        Assert.That(program.Lines.Last(), Does.StartWith(ConsoleMessages.Line("--frames: /dev/full: ")));
    }

    [Test]
    public async Task Gateway_UnwritableErrors_KeepsServing()
    {
        using var gateway = Gateway("simulate --sync-port 0 --ws-port 0 2>/dev/full");
        await gateway.PrintsAsync("state serving");
        using var client = await RawRosbridgeClient.ConnectAsync(new Uri(gateway.ValueOf("websocket")));

        // An unknown operation is counted and becomes an event, which the gateway logs.
        await client.SendAsync("""{"op":"unknown"}""");
        await client.ReceiveTextAsync();
        await client.SendAsync("""{"op":"subscribe","topic":"/joint_states"}""");
        await client.ReceiveTextAsync();

        Assert.That(await gateway.InterruptAsync(), Is.EqualTo(130), gateway.All);
    }

    [Test]
    public async Task Gateway_UnwritableOutput_KeepsServing()
    {
        using var gateway = Gateway("serve --sync-port 0 --ws-port 0 >/dev/full");

        await gateway.PrintsAsync("standard output: ");

        Assert.That(await gateway.InterruptAsync(), Is.EqualTo(130), gateway.All);
    }

    static PeerProcess Cli(string arguments) => Program("Nowpose.Cli.dll", arguments);

    static PeerProcess Gateway(string arguments) => Program("Nowpose.Gateway.dll", arguments);

    static PeerProcess Program(string assembly, string arguments) =>
        PeerProcess.OfShell($"exec dotnet '{Path.Combine(AppContext.BaseDirectory, assembly)}' {arguments}");
}
