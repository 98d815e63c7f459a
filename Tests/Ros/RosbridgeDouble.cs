using System.Net.Sockets;
using Nowpose.Headless.Tests.Network;

namespace Nowpose.Headless.Tests.Ros;

/// <summary>Simulates a rosbridge server, which Debian does not package. Written from rosbridge's protocol document and source code.</summary>
/// <remarks>
/// Follows the branches ros1 and ros2 of rosbridge_suite: operations, type names, format and order of responses, threads of service calls, and
/// errors that are only logged. Omits features that headsets do not use: throttling and queues of subscriptions, PNG and CBOR, services and
/// actions of clients, parameters.
/// </remarks>
sealed class RosbridgeDouble : IDisposable
{
    readonly FakeWebSocketServer _server = new();
    readonly CancellationTokenSource _stop = new();
    readonly List<RosbridgeDoubleClient> _clients = [];
    readonly Task _serving;
    int _inFlight, _maxInFlight;

    public RosbridgeDouble(RosGraph graph)
    {
        Graph = graph;
        _serving = Task.Run(ServeAsync);
    }

    public RosGraph Graph { get; }
    public int Port => _server.Port;

    /// <summary>Duration of a service call before the time is read. In ROS 2, the service is looked up in each call.</summary>
    public TimeSpan BeforeReading { get; set; }

    /// <summary>Duration of a service call after the time is read.</summary>
    public TimeSpan AfterReading { get; set; }

    /// <summary>Whether calls are accepted but receive no response, as when the list of allowed services excludes the service.</summary>
    public bool IsMute { get; set; }

    /// <summary>Largest number of calls that have been in progress at the same time.</summary>
    public int MaxInFlight => Volatile.Read(ref _maxInFlight);

    public int Connections { get { lock (_clients) return _clients.Count; } }

    /// <summary>Sends a message to all clients, although none has requested it.</summary>
    public void Send(string text)
    {
        lock (_clients)
            foreach (var client in _clients) client.Send(text);
    }

    public void Dispose()
    {
        _stop.Cancel();
        _server.Dispose();
        _serving.Wait(Soon.Limit);
    }

    public void CallBegun()
    {
        var now = Interlocked.Increment(ref _inFlight);
        if (now > MaxInFlight) Volatile.Write(ref _maxInFlight, now);
    }

    public void CallEnded() => Interlocked.Decrement(ref _inFlight);

    async Task ServeAsync()
    {
        while (!_stop.IsCancellationRequested)
        {
            try
            {
                var client = new RosbridgeDoubleClient(this, await _server.AcceptAsync(), _stop.Token);
                lock (_clients) _clients.Add(client);
                _ = client.RunAsync();
            }
            catch (Exception end) when (end is SocketException or ObjectDisposedException or TimeoutException or IOException or InvalidOperationException)
            {
                // The server was stopped, no client connected for some time, or a client disconnected before its upgrade.
            }
        }
    }
}
