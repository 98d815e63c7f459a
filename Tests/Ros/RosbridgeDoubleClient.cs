using System.Diagnostics;
using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Threading.Channels;

namespace Nowpose.Headless.Tests.Ros;

/// <summary>A connection of a <see cref="RosbridgeDouble"/>.</summary>
sealed class RosbridgeDoubleClient(RosbridgeDouble server, WebSocket socket, CancellationToken stop)
{
    const string GetTime = "/rosapi/get_time";

    readonly Channel<string> _outgoing = Channel.CreateUnbounded<string>();
    readonly HashSet<string> _advertised = [];
    readonly List<string> _fragments = [];

    RosGraph Graph => server.Graph;

    public void Send(string text) => _outgoing.Writer.TryWrite(text);

    public async Task RunAsync()
    {
        Action<string> send = Send;
        var sending = SendAllAsync();
        try
        {
            while (await ReceiveAsync() is { } text) await TakeAsync(text, send);
        }
        catch (Exception end) when (end is WebSocketException or IOException or OperationCanceledException or ObjectDisposedException)
        {
            // The client disconnected, or the server was stopped.
        }
        Graph.Forget(send);
        _outgoing.Writer.Complete();
        await sending;
        socket.Dispose();
    }

    async Task SendAllAsync()
    {
        try
        {
            await foreach (var text in _outgoing.Reader.ReadAllAsync(stop))
                await socket.SendAsync(Encoding.UTF8.GetBytes(text), WebSocketMessageType.Text, true, stop);
        }
        catch (Exception end) when (end is WebSocketException or IOException or OperationCanceledException or ObjectDisposedException)
        {
            // The client disconnected, or the server was stopped.
        }
    }

    async Task<string> ReceiveAsync()
    {
        var buffer = new byte[64 * 1024];
        var text = new StringBuilder();
        while (true)
        {
            var piece = await socket.ReceiveAsync(buffer, stop);
            if (piece.MessageType == WebSocketMessageType.Close) return null;
            text.Append(Encoding.UTF8.GetString(buffer, 0, piece.Count));
            if (piece.EndOfMessage) return text.ToString();
        }
    }

    async Task TakeAsync(string text, Action<string> send)
    {
        if (Parse(text) is not { } message) return;
        var op = (string)message["op"];
        try
        {
            await DoAsync(op, message, send);
        }
        catch (RosException mistake)
        {
            Graph.Error($"{op}: {mistake.Message}");
        }
    }

    // The real server stores invalid JSON and waits for the rest. Headsets send only complete messages.
    JsonObject Parse(string text)
    {
        try
        {
            return JsonNode.Parse(text) as JsonObject;
        }
        catch (JsonException)
        {
            Graph.Error("not JSON: " + text);
            return null;
        }
    }

    async Task DoAsync(string op, JsonObject message, Action<string> send)
    {
        var (topic, type) = ((string)message["topic"], (string)message["type"]);
        switch (op)
        {
            case "subscribe":
                Graph.Establish(topic, type);
                Graph.Subscribe(topic, send);
                break;
            case "unsubscribe": Graph.Forget(send); break;
            case "advertise":
                Graph.Establish(topic, type ?? throw new RosException("Expected a type field but none was found."));
                _advertised.Add(topic);
                break;
            case "unadvertise": _advertised.Remove(topic); break;
            case "publish":
                // A publisher that is not registered is registered with the type in the message or, if there is none, with the known type.
                if (_advertised.Add(topic)) Graph.Establish(topic, type);
                Graph.Receive(topic, (JsonObject)message["msg"]);
                break;
            case "call_service": await CallAsync(message); break;
            case "fragment": await DefragmentAsync(message, send); break;
            default: throw new RosException($"Unknown operation: {op}.  Allowed operations: ['subscribe', 'publish', …]");
        }
    }

    Task CallAsync(JsonObject call)
    {
        // ROS 1 uses a thread per call. In ROS 2, the client's next message waits for the response.
        var answering = AnswerAsync((string)call["service"], (string)call["id"]);
        return Graph.Flavour == RosFlavour.Ros2 ? answering : Task.CompletedTask;
    }

    async Task AnswerAsync(string service, string id)
    {
        server.CallBegun();
        var name = service.StartsWith('/') ? service : $"{Graph.Namespace}/{service}";
        await PassAsync(server.BeforeReading);
        var isKnown = name == Graph.Namespace + GetTime && Graph.HasRosapi;
        JsonNode values = isKnown ? new JsonObject { ["time"] = Graph.Time() } : $"Service {name} does not exist";
        if (!isKnown) Graph.Error($"call_service InvalidServiceException: {values}");
        await PassAsync(server.AfterReading);
        server.CallEnded();
        var response = new JsonObject { ["op"] = "service_response", ["service"] = service, ["values"] = values, ["result"] = isKnown };
        if (id != null) response["id"] = id;
        if (!server.IsMute) Send(response.ToJsonString());
    }

    // Delays repeatedly, because a single delay can end some milliseconds early.
    async Task PassAsync(TimeSpan time)
    {
        for (var since = Stopwatch.StartNew(); since.Elapsed < time;) await Task.Delay(1, stop);
    }

    async Task DefragmentAsync(JsonObject fragment, Action<string> send)
    {
        _fragments.Add((string)fragment["data"]);
        if (_fragments.Count < (int)fragment["total"]) return;
        var whole = string.Concat(_fragments);
        _fragments.Clear();
        await TakeAsync(whole, send);
    }
}
