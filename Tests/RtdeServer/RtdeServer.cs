using System.Collections.Concurrent;
using System.Net;
using System.Net.Sockets;

namespace Nowpose.RtdeServer;

/// <summary>Accepts clients and sends them their data in each control cycle.</summary>
sealed class RtdeServer
{
    const int GarbageBytes = 1024, LostEvery = 10;

    readonly Controller _controller;
    readonly ConcurrentDictionary<RtdeClient, bool> _clients = new();
    readonly TcpListener _listener;
    readonly RobotState _state = new();
    readonly Random _random = new(30004);

    public RtdeServer(Controller controller, IPAddress address, int port, double cyclesPerSecond, bool isESeries)
    {
        _controller = controller;
        CyclesPerSecond = cyclesPerSecond;
        Version = isESeries ? (5u, 11u, 1u, 108318u) : (3u, 15u, 8u, 106339u);
        _listener = new TcpListener(address, port);
        _listener.Start();
    }

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    public double CyclesPerSecond { get; }

    public (uint Major, uint Minor, uint Bugfix, uint Build) Version { get; }

    /// <summary>The fault that the server currently simulates.</summary>
    public Fault Fault { get; private set; }

    /// <summary>Starts or ends the simulation of a fault. Thread-safe.</summary>
    public void Apply(Fault fault)
    {
        switch (fault)
        {
            case Fault.Restart:
                lock (_controller) _controller.Restart();
                foreach (var client in _clients.Keys) client.Dispose();
                break;
            case Fault.ClockBack:
                lock (_controller) _controller.Restart();
                break;
            case Fault.ProtectiveStop:
                lock (_controller) _controller.Stop(SafetyMode.ProtectiveStop);
                break;
            case Fault.ProgramStop:
                lock (_controller) _controller.Stop(SafetyMode.Normal);
                break;
            case Fault.Resume:
                lock (_controller) _controller.Resume();
                Fault = Fault.None;
                break;
            default:
                Fault = fault;
                break;
        }
    }

    /// <summary>Whether another client has set up an input.</summary>
    public bool IsUsedByAnother(string input, RtdeClient client) => _clients.Keys.Any(other => other != client && other.Inputs.Contains(input));

    public async Task AcceptAsync()
    {
        while (true)
        {
            var client = new RtdeClient(await _listener.AcceptSocketAsync(), this);
            if (Fault == Fault.OneClient && !_clients.IsEmpty)
            {
                client.Dispose();
                continue;
            }

            _clients[client] = true;
            _ = ServeAsync(client);
        }
    }

    /// <summary>Sends cycles on this thread until the server is disposed.</summary>
    public void RunCycles()
    {
        // `length` is the duration of a cycle in s; `last` is the number of the last cycle that was sent.
        var length = 1 / CyclesPerSecond;
        for (long last = 0; ; last = SendNext(last, length))
        {
            TimeSpan wait;
            lock (_controller) wait = _controller.Until(NextAfter(last, length) * length);
            if (wait > TimeSpan.Zero) Thread.Sleep(wait);
        }
    }

    // Returns the number of the next cycle. After a restart of the controller, the numbers start again at zero.
    long NextAfter(long last, double length)
    {
        var current = (long)Math.Floor(_controller.Now / length);
        return current < last - 1 ? current + 1 : last + 1;
    }

    // Sends the data of the current cycle and skips missed cycles, as a busy controller does. Returns the number of the completed cycle.
    long SendNext(long last, double length)
    {
        long cycle;
        lock (_controller)
        {
            cycle = (long)Math.Floor(_controller.Now / length);
            if (cycle == last) return cycle;
            _controller.Read(cycle * length, _state);
        }

        if (Fault == Fault.LostPackages && cycle % LostEvery == 0) return cycle;
        foreach (var client in _clients.Keys) Send(client, cycle);
        return cycle;
    }

    void Send(RtdeClient client, long cycle)
    {
        if (Fault != Fault.Garbage)
        {
            client.SendCycle(cycle, _state);
            return;
        }

        Span<byte> garbage = stackalloc byte[GarbageBytes];
        _random.NextBytes(garbage);
        client.SendGarbage(garbage);
    }

    async Task ServeAsync(RtdeClient client)
    {
        await client.RunAsync();
        _clients.TryRemove(client, out _);
        client.Dispose();
    }
}
