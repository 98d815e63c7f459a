using System.Diagnostics;
using System.Globalization;
using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests the files with which systemd and containers start the gateway. Neither can run in a test, so tools check the files.</summary>
public class PackagingTests
{
    const string Program = "/opt/nowpose-gateway/Nowpose.Gateway";

    static readonly string Folder = Path.Combine(RepositoryFiles.Root, "Gateway", "Packaging");
    static readonly string[] Instructions =
        ["FROM", "RUN", "WORKDIR", "COPY", "USER", "ENV", "EXPOSE", "VOLUME", "HEALTHCHECK", "STOPSIGNAL", "ENTRYPOINT", "CMD"];

    string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-packaging-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    static string Unit => File.ReadAllText(Path.Combine(Folder, "nowpose-gateway.service"));

    // Saves the unit with a different path to the program, because the program is not installed on the test machine.
    string SavedUnit()
    {
        var path = Path.Combine(_folder, "nowpose-gateway.service");
        File.WriteAllText(path, Unit.Replace(Program, "/bin/true"));
        return path;
    }

    static (int Status, string Output) Analyze(params string[] arguments)
    {
        const string Tool = "/usr/bin/systemd-analyze";
        Needs.Program(File.Exists(Tool), "systemd");
        var start = new ProcessStartInfo(Tool, arguments) { RedirectStandardOutput = true, RedirectStandardError = true };
        using var process = Process.Start(start);
        var errors = process.StandardError.ReadToEndAsync();
        var output = process.StandardOutput.ReadToEnd();
        Assert.That(process.WaitForExit(Soon.Limit), Is.True);
        return (process.ExitCode, output + errors.Result);
    }

    [Test]
    public void Gateway_RuntimeSettings_PreventSpinningOfIdleThreads()
    {
        using var settings = JsonDocument.Parse(File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "Nowpose.Gateway.runtimeconfig.json")));

        var properties = settings.RootElement.GetProperty("runtimeOptions").GetProperty("configProperties");
        Assert.That(properties.GetProperty("System.Threading.ThreadPool.UnfairSemaphoreSpinLimit").GetInt32(), Is.Zero);
    }

    [Test]
    public void SystemdUnit_Analysis_ReportsNoError()
    {
        var (status, output) = Analyze("verify", "--man=no", SavedUnit());

        Assert.That(status, Is.EqualTo(0), output);
        Assert.That(output, Does.Not.Contain("nowpose-gateway.service:"), "no entry is ignored");
    }

    [Test]
    public void SystemdUnit_SecurityAnalysis_ReportsLowExposure()
    {
        var (_, output) = Analyze("security", "--offline=true", "--no-pager", SavedUnit());

        var exposure = Regex.Match(output, @"Overall exposure level for [^:]+: ([\d.]+)");
        Assert.That(exposure.Success, Is.True, output);
        Assert.That(double.Parse(exposure.Groups[1].Value, CultureInfo.InvariantCulture), Is.LessThan(2.0), output);
    }

    [Test]
    public void SystemdUnit_Sandbox_HasAnUnprivilegedUserAndAllowsRuntimeCompilation()
    {
        Assert.That(Unit, Does.Contain("\nType=exec\n").And.Contain("\nUser=nowpose\nGroup=nowpose\n").And.Contain("\nNoNewPrivileges=yes\n"));
        Assert.That(Unit, Does.Not.Match(@"(?m)^MemoryDenyWriteExecute"), ".NET and Node.js compile at runtime");
        Assert.That(Unit, Does.Not.Match(@"(?mi)^User=root"));
    }

    [Test]
    public void SystemdUnit_User_IsCreatedBySystemdSysusers()
    {
        var users = File.ReadAllLines(Path.Combine(Folder, "nowpose-gateway.sysusers.conf")).Where(line => line[0] != '#');

        Assert.That(users.Single(), Does.Match("^u nowpose - \"[^\"]+\" /var/lib/nowpose-gateway$"));
    }

    // Both ports are in the range from which Linux takes the ports of outgoing connections.
    [Test]
    public void Sysctl_ReservedPorts_AreTheDefaultPorts()
    {
        var settings = File.ReadAllLines(Path.Combine(Folder, "nowpose-gateway.sysctl.conf")).Where(line => line[0] != '#');

        Assert.That(
            settings.Single(),
            Is.EqualTo($"net.ipv4.ip_local_reserved_ports = {ProtocolLimits.SyncPort},{ProtocolLimits.WebSocketPort}"));
    }

    [Test]
    public void SystemdUnit_GatewayFails_RestartsItWithoutLimit()
    {
        Assert.That(Unit, Does.Contain("\nStartLimitIntervalSec=0\n").And.Contain("\nRestart=on-failure\n"));
        Assert.That(Unit, Does.Not.Contain("StartLimitBurst"));
    }

    // The unit must not copy the tokens: a copy would still contain tokens that were removed from the file. It must not check the
    // configuration before the start either, because a failed check would be repeated forever.
    [Test]
    public void SystemdUnit_TokensFile_IsReadByTheGatewayItself()
    {
        var entries = Unit.Split('\n').Where(line => !line.StartsWith('#')).ToArray();

        Assert.That(entries.Single(line => line.StartsWith("ExecStart=")), Does.Contain(" --tokens /etc/nowpose/tokens.txt "));
        Assert.That(entries, Has.None.StartsWith("LoadCredential").And.None.StartsWith("ExecStartPre"));
        Assert.That(entries, Has.Some.EqualTo("RestartPreventExitStatus=2"));
    }

    [Test]
    public async Task SystemdUnit_Command_IsValid()
    {
        File.WriteAllText(Path.Combine(_folder, "tokens.txt"), "observer a-token-of-an-observer\n");
        File.Copy(Path.Combine(Folder, "gateway.yaml"), Path.Combine(_folder, "gateway.yaml"));
        Directory.CreateDirectory(Path.Combine(_folder, "nowpose-gateway"));
        var command = Regex.Match(Unit, $"(?m)^ExecStart={Regex.Escape(Program)} (.*)$").Groups[1].Value
            .Replace("/etc/nowpose", _folder).Replace("%S", _folder);

        var check = await CheckAsync(command.Split(' '));

        Assert.That(check.Status, Is.EqualTo(0), check.Errors);
    }

    [Test]
    public void Container_FinalStage_HasAnUnprivilegedUserAndAHealthCheck()
    {
        var lines = File.ReadAllText(Path.Combine(Folder, "Containerfile")).Replace("\\\n", " ").Split('\n')
            .Where(line => line.Length > 0 && line[0] != '#').Select(line => line.Split(' ', 2)).ToArray();

        Assert.That(lines.Select(line => line[0]).Distinct(), Is.SubsetOf(Instructions));
        Assert.That(lines[0][0], Is.EqualTo("FROM"));
        Assert.That(lines.Last(line => line[0] == "USER")[1], Is.EqualTo("app"));
        Assert.That(Array.FindLastIndex(lines, line => line[0] == "RUN"), Is.LessThan(Array.FindLastIndex(lines, line => line[0] == "USER")));
        Assert.That(lines.Single(line => line[0] == "HEALTHCHECK")[1], Does.Contain("/healthz").And.Contain($":{ProtocolLimits.WebSocketPort}/"));
        var environment = lines.Where(line => line[0] == "ENV").Select(line => line[1]).ToArray();
        Assert.That(environment, Does.Contain("STATE_DIRECTORY=" + lines.Last(line => line[0] == "WORKDIR")[1]).And.Contain("MALLOC_ARENA_MAX=1"));
        Assert.That(lines.Single(line => line[0] == "EXPOSE")[1], Is.EqualTo($"{ProtocolLimits.SyncPort}/tcp {ProtocolLimits.WebSocketPort}/tcp"));
    }

    [Test]
    public void Container_Node_IsCopiedFromOnePinnedImage()
    {
        var text = File.ReadAllText(Path.Combine(Folder, "Containerfile"));

        Assert.That(text, Does.Match(@"(?m)^FROM docker\.io/library/node:22-\S+ AS node$").And.Not.Match("apt-get install [^&]*nodejs"));
        Assert.That(Regex.Count(text, "(?m)^COPY --from=node /usr/local/bin/node "), Is.EqualTo(2), "in the build stage and the final stage");
    }

    [Test]
    public void Container_Context_ExcludesLocalBuilds()
    {
        var ignored = File.ReadAllLines(Path.Combine(RepositoryFiles.Root, ".containerignore"));

        Assert.That(ignored, Is.SupersetOf(new[] { "**/bin", "**/obj", "**/node_modules", "**/dist", ".git" }));
    }

    [TestCase("Containerfile")]
    [TestCase("../../Packages/com.nowpose.mril/Documentation~/gateway-installation.md")]
    public void Container_BuildCommand_KeepsTheHealthCheck(string path) =>
        Assert.That(File.ReadAllText(Path.Combine(Folder, path)), Does.Contain("podman build --format docker -f Gateway/Packaging/Containerfile"));

    [Test]
    public async Task Container_Command_IsValid()
    {
        File.Copy(Path.Combine(Folder, "gateway.yaml"), Path.Combine(_folder, "gateway.yaml"));
        var command = Regex.Match(File.ReadAllText(Path.Combine(Folder, "Containerfile")), @"(?m)^CMD \[(.*)\]$").Groups[1].Value
            .Replace("/etc/nowpose", _folder).Replace("/var/lib/nowpose-gateway", _folder);

        var check = await CheckAsync([.. command.Split(',').Select(word => word.Trim(' ', '"'))]);

        Assert.That(check.Status, Is.EqualTo(0), check.Errors);
    }

    static async Task<(int Status, string Errors)> CheckAsync(string[] command)
    {
        var (status, _, errors) = await CapturedConsole.OfAsync(
            () => Nowpose.Gateway.CommandLine.RunAsync([.. command, "--check", "--ws-port", "0", "--sync-port", "0"]).Bounded());
        return (status, errors);
    }
}
