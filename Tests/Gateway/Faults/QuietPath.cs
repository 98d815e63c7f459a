using System.Net;
using System.Net.Sockets;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>
/// Simulates a network between headset and gateway that can fail like WiFi: it carries no data in either direction, and neither side is
/// notified, not even when the other side closes its connection. Data sent in the meantime arrive as soon as it recovers; in a network that
/// loses packets, they arrive only when TCP sends them again.
/// </summary>
sealed class QuietPath : IDisposable
{
    readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    readonly IPEndPoint _target;
    readonly List<Socket> _sockets = [];
    readonly CancellationTokenSource _stop = new();
    readonly object _gate = new();
    TaskCompletionSource _carries = new(TaskCreationOptions.RunContinuationsAsynchronously);

    public QuietPath(IPEndPoint target)
    {
        _target = target;
        _carries.SetResult();
        _listener.Start();
        _ = AcceptAsync();
    }

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    public IPEndPoint EndPoint => (IPEndPoint)_listener.LocalEndpoint;

    public void GoQuiet()
    {
        lock (_gate) _carries = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
    }

    /// <summary>Closes all existing connections.</summary>
    public void Interrupt()
    {
        lock (_gate)
        {
            foreach (var socket in _sockets) socket.Dispose();
            _sockets.Clear();
        }
    }

    public void Recover()
    {
        lock (_gate) _carries.TrySetResult();
    }

    public void Dispose()
    {
        _stop.Cancel();
        _listener.Dispose();
        lock (_gate)
            foreach (var socket in _sockets) socket.Dispose();
        Recover();
        _stop.Dispose();
    }

    Task Carries()
    {
        lock (_gate) return _carries.Task;
    }

    async Task AcceptAsync()
    {
        try
        {
            while (true)
            {
                var near = await _listener.AcceptSocketAsync(_stop.Token);
                _ = JoinAsync(near);
            }
        }
        catch (Exception end) when (end is OperationCanceledException or SocketException or ObjectDisposedException)
        {
            // Dispose has closed the listener.
        }
    }

    async Task JoinAsync(Socket near)
    {
        var far = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        near.NoDelay = true;
        lock (_gate) _sockets.AddRange([near, far]);
        try
        {
            await Carries();
            await far.ConnectAsync(_target);
            await Task.WhenAll(CarryAsync(near, far), CarryAsync(far, near));
        }
        catch (Exception end) when (end is SocketException or ObjectDisposedException)
        {
            // One side has closed the connection.
        }
        finally
        {
            near.Dispose();
            far.Dispose();
        }
    }

    async Task CarryAsync(Socket from, Socket to)
    {
        var piece = new byte[16 * 1024];
        while (true)
        {
            var count = await from.ReceiveAsync(piece);
            // Data in transit arrive after the pause, because TCP sends them again.
            await Carries();
            if (count == 0)
            {
                to.Shutdown(SocketShutdown.Send);
                return;
            }

            await to.SendAsync(piece.AsMemory(0, count));
        }
    }
}
