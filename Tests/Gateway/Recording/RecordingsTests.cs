using System.Collections.Concurrent;
using System.Net;
using System.Net.Http.Headers;
using System.Net.Sockets;
using System.Text;
using System.Text.Json;
using Nowpose.Gateway.Messages;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Status.Events;

namespace Nowpose.Headless.Tests.Gateway.Recording;

/// <summary>Tests the list of a gateway's recordings, their download, and files that are deleted while the gateway runs.</summary>
public class RecordingsTests
{
    const string Secret = "not for download";

    string _outer;
    string _folder;

    [SetUp]
    public void SetUp()
    {
        _outer = Directory.CreateTempSubdirectory("nowpose-recordings-").FullName;
        _folder = Directory.CreateDirectory(Path.Combine(_outer, "recordings")).FullName;
        File.WriteAllText(Path.Combine(_outer, "tokens.jsonl"), Secret);
        File.WriteAllText(Path.Combine(_folder, "tokens.txt"), Secret);
    }

    [TearDown]
    public void TearDown() => Directory.Delete(_outer, true);

    Task<GatewayServer> StartAsync(bool hasTokens = false) =>
        Gateways.StartAsync(Gateways.Options() with { Recordings = _folder, Tokens = hasTokens ? Gateways.Tokens : Nowpose.Gateway.Security.TokenList.None });

    static async Task<(HttpStatusCode Status, string Text)> GetAsync(GatewayServer gateway, string path, string token = null)
    {
        using var http = new HttpClient();
        using var request = new HttpRequestMessage(HttpMethod.Get, new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}{path}"));
        if (token != null) request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        using var response = await http.SendAsync(request).Bounded();
        return (response.StatusCode, await response.Content.ReadAsStringAsync().Bounded());
    }

    // Sends the path unchanged; HttpClient would resolve the dots in it.
    static async Task<string> GetRawAsync(GatewayServer gateway, string path)
    {
        using var tcp = new TcpClient();
        await tcp.ConnectAsync(gateway.WebSocketEndPoint).Bounded();
        var port = gateway.WebSocketEndPoint.Port;
        await tcp.GetStream().WriteAsync(Encoding.ASCII.GetBytes($"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n")).AsTask().Bounded();
        using var reader = new StreamReader(tcp.GetStream());
        return await reader.ReadToEndAsync().Bounded();
    }

    static async Task<JsonElement> StateAsync(GatewayServer gateway) =>
        JsonDocument.Parse((await GetAsync(gateway, "/operations/state")).Text).RootElement;

    [Test]
    public async Task List_FolderWithOtherFiles_ContainsOnlyRecordingsWithNameAndSize()
    {
        File.WriteAllText(Path.Combine(_folder, "press-20261120T120000Z.jsonl"), "12345\n");
        await using var gateway = await StartAsync();

        var one = JsonDocument.Parse((await GetAsync(gateway, "/operations/recordings")).Text).RootElement.EnumerateArray().Single();

        Assert.That(one.GetProperty("name").GetString(), Is.EqualTo("press-20261120T120000Z.jsonl"));
        Assert.That(one.GetProperty("bytes").GetInt64(), Is.EqualTo(6));
        Assert.That((await GetAsync(gateway, "/operations/recordings/press-20261120T120000Z.jsonl")).Text, Is.EqualTo("12345\n"));
    }

    [Test]
    public void Refreshed_FileThatHasGrown_HasItsCurrentSize()
    {
        var path = Path.Combine(_folder, "press.jsonl");
        File.WriteAllText(path, "");
        var file = new FileInfo(path);
        Assert.That(file.Length, Is.Zero);

        File.WriteAllText(path, "12345\n");

        Assert.That(RecordingsFolder.Refreshed(file).Length, Is.EqualTo(6));
    }

    [TestCase(null, HttpStatusCode.Unauthorized)]
    [TestCase(Gateways.ObserverToken, HttpStatusCode.Forbidden)]
    [TestCase(Gateways.SourceToken, HttpStatusCode.Forbidden)]
    [TestCase(Gateways.OperatorToken, HttpStatusCode.OK)]
    public async Task Recordings_GatewayWithTokens_RequireAnOperator(string token, HttpStatusCode expected)
    {
        File.WriteAllText(Path.Combine(_folder, "a.jsonl"), "{}\n");
        await using var gateway = await StartAsync(hasTokens: true);

        foreach (var path in new[] { "/operations/recordings", "/operations/recordings/a.jsonl" })
            Assert.That((await GetAsync(gateway, path, token)).Status, Is.EqualTo(expected), path);
    }

    [TestCase("..%2Ftokens.jsonl")]
    [TestCase("..%5Ctokens.jsonl")]
    [TestCase("%2e%2e%2ftokens.jsonl")]
    [TestCase("%252e%252e%252ftokens.jsonl")]
    [TestCase("./tokens.txt")]
    [TestCase("tokens.txt")]
    [TestCase("tokens.txt%00.jsonl")]
    [TestCase("link.jsonl")]
    [TestCase("a.jsonl/")]
    [TestCase("none.jsonl")]
    [TestCase("a.jsonl%0a")]
    public async Task Download_NotARecordingInTheFolder_IsRefusedWithoutContents(string name)
    {
        File.WriteAllText(Path.Combine(_folder, "a.jsonl"), "{}\n");
        if (!OperatingSystem.IsWindows()) File.CreateSymbolicLink(Path.Combine(_folder, "link.jsonl"), Path.Combine(_outer, "tokens.jsonl"));
        await using var gateway = await StartAsync();

        var answer = await GetRawAsync(gateway, $"/operations/recordings/{name}");

        Assert.That(answer, Does.StartWith("HTTP/1.1 4").And.Not.Contain(Secret));
    }

    [Test]
    public async Task Download_RecordingInProgress_ReturnsCompleteLines()
    {
        await using var gateway = await StartAsync();
        gateway.Recorder.SwitchOn();
        await Soon.BecomesAsync(() => File.Exists(gateway.Recorder.Path) && new FileInfo(gateway.Recorder.Path).Length > 0, "the header is written");

        var (status, text) = await GetAsync(gateway, $"/operations/recordings/{Path.GetFileName(gateway.Recorder.Path)}");

        Assert.That(status, Is.EqualTo(HttpStatusCode.OK));
        Assert.That(text, Does.EndWith("\n"));
    }

    [Test]
    public async Task Recording_FileDeletedWhileWritten_ReportsAProblemAndEnds()
    {
        await using var gateway = await StartAsync();
        gateway.Recorder.SwitchOn();
        await Soon.BecomesAsync(() => File.Exists(gateway.Recorder.Path), "the recording exists");

        File.Delete(gateway.Recorder.Path);

        await Soon.BecomesAsync(() => !gateway.Recorder.IsOn, "it is noticed");
        var state = await StateAsync(gateway);
        var recording = state.GetProperty("recording");
        Assert.That(recording.GetProperty("problem").GetString(), Is.EqualTo(RecorderMessages.Deleted));
        Assert.That(recording.GetProperty("lines").GetInt64(), Is.Zero, "no line can be read from a deleted file");
        Assert.That(recording.GetProperty("bytes").GetInt64(), Is.Zero);
        Assert.That(state.GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("warning"));
        Assert.That(state.GetProperty("status").GetProperty("text").GetString(), Does.EndWith(EventRemedies.RecordAgain));
        gateway.Recorder.SwitchOn();
        Assert.That(gateway.Recorder.IsOn, "a new file");
    }

    [Test]
    public async Task Recording_FileDeletedAfterItsEnd_RaisesAnEvent()
    {
        await using var gateway = await StartAsync();
        gateway.Recorder.SwitchOn();
        await gateway.Recorder.SwitchOffAsync().Bounded();
        var (path, name) = (gateway.Recorder.Path, Path.GetFileName(gateway.Recorder.Path));
        gateway.RecordingsWatch.Look();

        File.Delete(path);

        await Soon.BecomesAsync(
            () => StateAsync(gateway).Result.GetProperty("events").EnumerateArray().Any(
                one => one.GetProperty("which").GetString() == name && one.GetProperty("what").GetString() == "was deleted"),
            "the deletion is an event");
        Assert.That((await StateAsync(gateway)).GetProperty("recording").GetProperty("deleted").GetBoolean());
        Assert.That((await StateAsync(gateway)).GetProperty("recording").TryGetProperty("problem", out _), Is.False);
    }

    [Test]
    public async Task Recordings_FolderTemporarilyNotReadable_AreNotReportedAsDeleted()
    {
        await using var gateway = await StartAsync();
        var (path, away) = (Path.Combine(_folder, "a.jsonl"), _folder + "-away");
        File.WriteAllText(path, "{}\n");
        var events = new EventList(TimeProvider.System, (_, _) => { });
        var log = new ConcurrentQueue<string>();
        using var watch = new RecordingsWatch(gateway.Recorder, new RecordingsFolder(_folder), events, log.Enqueue);

        Directory.Move(_folder, away);
        for (var look = 0; look < 3; look++) watch.LookUnlessBusy();
        var (status, text) = await GetAsync(gateway, "/operations/recordings");
        Directory.Move(away, _folder);
        watch.LookUnlessBusy();

        Assert.That(status, Is.EqualTo(HttpStatusCode.ServiceUnavailable));
        Assert.That(text.TrimEnd(), Does.Match(MessagePattern.Of(RecorderMessages.FolderNotRead(MessagePattern.Any))));
        Assert.That(log, Has.Count.EqualTo(1).And.All.Match(MessagePattern.Of(RecorderMessages.FolderNotChecked(MessagePattern.Any))));
        Assert.That(events.Read(10), Is.Empty);
        File.Delete(path);
        watch.LookUnlessBusy();
        Assert.That(events.Read(10).Select(one => one.View.Which), Is.EqualTo(new[] { "a.jsonl" }));
    }

    [Test]
    public async Task Look_AddingAnEventFails_IsLogged()
    {
        await using var gateway = await StartAsync();
        var path = Path.Combine(_folder, "a.jsonl");
        File.WriteAllText(path, "{}\n");
        var log = new ConcurrentQueue<string>();
        var events = new EventList(TimeProvider.System, (_, _) => throw new InvalidOperationException("the log is full"));
        using var watch = new RecordingsWatch(gateway.Recorder, new RecordingsFolder(_folder), events, log.Enqueue);
        File.Delete(path);

        watch.LookUnlessBusy();

        Assert.That(log, Does.Contain(RecorderMessages.FolderNotChecked("InvalidOperationException: the log is full")));
    }

    [Test]
    public void Find_NameWithASeparator_ReturnsNull()
    {
        var folder = new RecordingsFolder(_folder);

        foreach (var name in new[] { "../tokens.jsonl", "/etc/passwd", "", ".jsonl", "a/../../tokens.jsonl" }) Assert.That(folder.Find(name), Is.Null, name);
        Assert.That(new RecordingsFolder(null).List(), Is.Empty);
    }
}
