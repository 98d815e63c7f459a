using System.Diagnostics;
using System.Net.Sockets;
using System.Net.WebSockets;
using Nowpose.Protocol;

namespace Nowpose.Benchmarks.Load;

/// <summary>A minimal client that uses both ports in the same way as a headset.</summary>
sealed class LeanHeadset : IDisposable
{
    static readonly TimeSpan SyncInterval = TimeSpan.FromMilliseconds(ProtocolLimits.SyncIntervalMs);
    const int ExchangesPerDiagnostics = 5;

    readonly LatencyCounts _latencies;
    readonly ControlTruth _truth;
    readonly long _intervalNs;
    readonly string _diagnostics;
    readonly byte[] _frame = new byte[SyncFrame.Size];
    WebSocket _positions;
    Socket _sync;
    uint _sequence;
    long _newestNs;
    long _received;
    long _lost;
    long _refused;

    /// <param name="name">Name in the client's diagnostics.</param>
    /// <param name="latencies">Collects the latencies of all clients.</param>
    public LeanHeadset(string name, double rateHz, LatencyCounts latencies, ControlTruth truth)
    {
        _latencies = latencies;
        _truth = truth;
        _intervalNs = (long)(1e9 / rateHz);
        _diagnostics = "{\"op\":\"publish\",\"topic\":\"/nowpose/diagnostics\",\"msg\":{\"header\":{\"stamp\":{\"sec\":1,\"nanosec\":0}},\"status\":"
            + $"[{{\"level\":0,\"name\":\"nowpose\",\"message\":\"\",\"hardware_id\":\"{name}\",\"values\":[{{\"key\":\"state\",\"value\":\"current\"}}]}}]}}}}";
    }

    public long Received => Interlocked.Read(ref _received);

    /// <summary>Number of missing samples, computed from the gaps between the received time stamps.</summary>
    public long Lost => Interlocked.Read(ref _lost);

    /// <summary>Number of unexpected messages. They mean that the gateway refused a message of this client.</summary>
    public long Refused => Interlocked.Read(ref _refused);

    /// <summary>Reason why the client ended; null while it runs.</summary>
    public string Problem { get; private set; }

    public async Task OpenAsync(GatewayProcess gateway)
    {
        _positions = await LeanSocket.OpenAsync(gateway.WebSocket);
        await LeanSocket.SendTextAsync(_positions, RosbridgeWriter.Subscribe(RosTopics.JointStates));
        _sync = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        await _sync.ConnectAsync(gateway.Sync);
        // Sends immediately, like a headset, because the gateway limits the number of connections that have sent nothing.
        if (!await TryExchangeAsync()) throw new InputException("the gateway closed the clock sync");
    }

    /// <summary>Runs until the client is disposed or the gateway closes the connection.</summary>
    public Task RunAsync() => Task.WhenAll(GuardAsync("positions", ReceiveAsync), GuardAsync("sync", ExchangeAsync));

    public void Clear()
    {
        Interlocked.Exchange(ref _received, 0);
        Interlocked.Exchange(ref _lost, 0);
    }

    public void Dispose()
    {
        _positions?.Dispose();
        _sync?.Dispose();
    }

    async Task GuardAsync(string what, Func<Task> work)
    {
        try
        {
            await work();
            Problem ??= what + ": the gateway closed it";
        }
        catch (Exception end) when (end is SocketException or WebSocketException or OperationCanceledException or ObjectDisposedException
            or InputException)
        {
            Problem ??= $"{what}: {end.Message}";
        }
    }

    async Task ReceiveAsync()
    {
        var buffer = new byte[32 * 1024];
        var length = 0;
        while (true)
        {
            var part = await _positions.ReceiveAsync(buffer.AsMemory(length), CancellationToken.None);
            var arrival = Stopwatch.GetTimestamp();
            if (part.MessageType == WebSocketMessageType.Close) return;
            length += part.Count;
            if (length == buffer.Length) throw new InputException("the gateway sent a message that is too long for a joint state");
            if (!part.EndOfMessage) continue;
            if (StampReader.TryRead(buffer.AsSpan(0, length), out var stampNs)) Count(stampNs, arrival);
            else Interlocked.Increment(ref _refused);
            length = 0;
        }
    }

    void Count(long stampNs, long arrival)
    {
        Interlocked.Increment(ref _received);
        _latencies.Add(_truth.NanosecondsAt(arrival) - stampNs);
        var skipped = _newestNs == 0 ? 0 : (long)Math.Round((stampNs - _newestNs) / (double)_intervalNs) - 1;
        if (skipped > 0) Interlocked.Add(ref _lost, skipped);
        _newestNs = stampNs;
    }

    async Task ExchangeAsync()
    {
        // Waits for a random part of the interval, so that the exchanges of the clients are distributed like those of real headsets.
        await Task.Delay(TimeSpan.FromMilliseconds(Random.Shared.NextDouble() * SyncInterval.TotalMilliseconds));
        while (await TryExchangeAsync())
        {
            if (_sequence % ExchangesPerDiagnostics == 0) await LeanSocket.SendTextAsync(_positions, _diagnostics);
            await Task.Delay(SyncInterval);
        }
    }

    // Returns false if the gateway closed the connection.
    async Task<bool> TryExchangeAsync()
    {
        SyncFrame.Request(++_sequence, Stopwatch.GetTimestamp()).Write(_frame);
        await _sync.SendAsync(_frame);
        for (var read = 0; read < _frame.Length;)
        {
            var count = await _sync.ReceiveAsync(_frame.AsMemory(read));
            if (count == 0) return false;
            read += count;
        }

        return true;
    }
}
