using System.Net.WebSockets;
using System.Text;
using Nowpose.Network;

namespace Nowpose.Headless.Tests.Network;

/// <summary>A rosbridge client, and the server to which it connects. The test controls the server.</summary>
sealed class PlayedServer : IDisposable
{
    public const string Good = """{"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":{"secs":5,"nsecs":0}},"name":["a"],"position":[1.5]}}""";

    public PlayedServer()
    {
        Server = new FakeWebSocketServer();
        Listener = new QueuedListener();
        var clock = new StopwatchHeadsetClock();
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: Server.Port);
        Client = new RosbridgeClient(() => WebSocketLinks.Create(settings, clock), clock, Listener, Subscriptions);
    }

    public FakeWebSocketServer Server { get; }
    public QueuedListener Listener { get; }
    public Subscriptions Subscriptions { get; } = Subscribed.ToRobot();
    public RosbridgeClient Client { get; }

    public static Task Send(WebSocket socket, string text, WebSocketMessageType type = WebSocketMessageType.Text, bool end = true) =>
        socket.SendAsync(Encoding.UTF8.GetBytes(text), type, end, CancellationToken.None);

    public static async Task<string> ReceiveAsync(WebSocket socket)
    {
        var buffer = new byte[4096];
        return Encoding.UTF8.GetString(buffer, 0, (await socket.ReceiveAsync(buffer, CancellationToken.None).Bounded()).Count);
    }

    public void Dispose()
    {
        Client.Dispose();
        Server.Dispose();
    }
}
