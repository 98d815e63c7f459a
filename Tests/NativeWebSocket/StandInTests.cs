using System.Reflection;
using NativeWebSocket;
using NUnit.Framework;
using Socket = NativeWebSocket.WebSocket;

namespace Nowpose.Headless.Tests;

/// <summary>
/// Checks that the stand-in behaves like the package that it replaces, including its defects, because the tests of the link depend on
/// them.
/// </summary>
public class StandInTests
{
    [Test]
    public void Socket_PublicMembers_MatchThePackage()
    {
        var members = typeof(Socket).GetMembers(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly)
            .Where(member => member is not MethodInfo { IsSpecialName: true })
            .Select(member => member is ConstructorInfo made ? string.Join(",", made.GetParameters().Select(p => p.ParameterType.Name)) : member.Name);

        Assert.That(members, Is.EquivalentTo(new[]
        {
            "String,Dictionary`2", "String,String,Dictionary`2", "String,List`1,Dictionary`2",
            "OnOpen", "OnMessage", "OnError", "OnClose", "State",
            "Connect", "Send", "SendText", "Receive", "Close", "CancelConnection", "DispatchMessageQueue",
        }));
    }

    [Test]
    public async Task Events_WithoutAContext_WaitUntilDispatched()
    {
        using var server = new FakeWebSocketServer();
        var socket = await Task.Run(() => new Socket($"ws://127.0.0.1:{server.Port}/"));
        var events = new List<string>();
        Listen(socket, events);
        var connected = socket.Connect();
        (await server.AcceptStreamAsync()).Close();
        await connected.Bounded();
        Assert.That(events, Is.Empty);

        socket.DispatchMessageQueue();

        Assert.That(events, Is.EqualTo(new[] { "open", "close Abnormal" }));
    }

    [Test]
    public async Task Events_WithAContext_ArePostedToIt()
    {
        using var server = new FakeWebSocketServer();
        var frame = new FrameContext();
        var socket = frame.Run(() => new Socket($"ws://127.0.0.1:{server.Port}/"));
        var events = new List<string>();
        Listen(socket, events);

        var connected = socket.Connect();
        (await server.AcceptStreamAsync()).Close();
        await connected.Bounded();
        socket.DispatchMessageQueue();

        Assert.That(frame.Posts, Is.EqualTo(2));
        Assert.That(events, Is.Empty);
    }

    [Test]
    public async Task Connect_Refused_RaisesErrorAndCloseWithoutException()
    {
        using var server = new FakeWebSocketServer();
        var socket = await Task.Run(() => new Socket($"ws://127.0.0.1:{server.Port}/"));
        var events = new List<string>();
        Listen(socket, events);

        var connected = socket.Connect();
        await server.AnswerAsync("HTTP/1.1 401 Unauthorized\r\nContent-Length: 0\r\n\r\n");
        await connected.Bounded();
        socket.DispatchMessageQueue();

        Assert.That(events, Has.Count.EqualTo(2));
        Assert.That(events[0], Does.StartWith("error ").And.Contain("'401'"));
        Assert.That(events[1], Is.EqualTo("close Abnormal"));
        Assert.That(socket.State, Is.EqualTo(WebSocketState.Closed));
        await socket.SendText("discarded");
    }

    static void Listen(Socket socket, List<string> events)
    {
        socket.OnOpen += () => events.Add("open");
        socket.OnMessage += data => events.Add("message " + data.Length);
        socket.OnError += message => events.Add("error " + message);
        socket.OnClose += code => events.Add("close " + code);
    }
}
