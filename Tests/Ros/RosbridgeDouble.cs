using System.Net.Sockets;
using Nowpose.Headless.Tests.Network;

namespace Nowpose.Headless.Tests.Ros;

/// <summary>A double of the rosbridge server, which Debian does not package, written from its protocol document and its source.</summary>
/// <remarks>
/// Follows rosbridge_suite's branches ros1 and ros2: operations, type names, the format and order of answers, the threads that serve
/// calls, and errors that are only logged. Leaves out features that headsets do not use: throttling and queues of subscriptions, PNG and
/// CBOR, services and actions of clients, parameters.
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

    /// <summary>Duration of a service call before the time is read: ROS 2 first looks up the service each time.</summary>
    public TimeSpan BeforeReading { get; set; }

    /// <summary>Duration of a service call after the time is read.</summary>
    public TimeSpan AfterReading { get; set; }

    /// <summary>Whether calls are accepted and never answered, as when the glob of allowed services excludes the service.</summary>
    public bool IsMute { get; set; }

    /// <summary>Maximum number of concurrent calls.</summary>
    public int MaxInFlight => Volatile.Read(ref _maxInFlight);

    public int Connections { get { lock (_clients) return _clients.Count; } }

    /// <summary>Sends an unsolicited message to every client.</summary>
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
                // The server was stopped, no client connected for a while, or a client left before its upgrade.
            }
        }
    }
}
