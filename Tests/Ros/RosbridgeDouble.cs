using System.Net.Sockets;
using Nowpose.Headless.Tests.Network;

namespace Nowpose.Headless.Tests.Ros;

/// <summary>Stands in for the rosbridge server, which Debian does not have, as its protocol's document and its source say it behaves.</summary>
/// <remarks>
/// After rosbridge_suite's branches ros1 and ros2: operations, type names, the shape and order of answers, which threads serve calls,
/// and that mistakes are told to the log only. Without what no headset uses: throttling and queues of subscriptions, PNG and CBOR,
/// services and actions of clients, parameters.
/// </remarks>
sealed class RosbridgeDouble : IDisposable
{
    readonly FakeWebSocketServer _server = new();
    readonly CancellationTokenSource _stop = new();
    readonly List<RosbridgeDoubleClient> _clients = [];
    readonly Task _serving;
    int _inFlight, _mostInFlight;

    public RosbridgeDouble(RosGraph graph)
    {
        Graph = graph;
        _serving = Task.Run(ServeAsync);
    }

    public RosGraph Graph { get; }
    public int Port => _server.Port;

    /// <summary>What a service call takes before the time is read: ROS 2 looks for the service each time first.</summary>
    public TimeSpan BeforeReading { get; set; }

    /// <summary>What it takes afterwards.</summary>
    public TimeSpan AfterReading { get; set; }

    /// <summary>Takes calls and never answers, as when a glob of allowed services leaves this one out.</summary>
    public bool IsMute { get; set; }

    /// <summary>The most calls of one moment.</summary>
    public int MostInFlight => Volatile.Read(ref _mostInFlight);

    public int Connections { get { lock (_clients) return _clients.Count; } }

    /// <summary>Sends what is not asked for to every client.</summary>
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
        if (now > MostInFlight) Volatile.Write(ref _mostInFlight, now);
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
                // Stopped, or nobody came for a while, or somebody left before its upgrade.
            }
        }
    }
}
