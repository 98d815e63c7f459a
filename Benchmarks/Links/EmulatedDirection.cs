using Microsoft.Win32.SafeHandles;
using Nowpose.Benchmarks.Load;

namespace Nowpose.Benchmarks.Links;

/// <summary>Transfers packets from one TUN device to another on a separate thread, with the delays and losses of a link profile.</summary>
sealed class EmulatedDirection : IDisposable
{
    /// <summary>Maximum duration of one wait. It limits the time until a stop is detected.</summary>
    static readonly TimeSpan MaxWait = TimeSpan.FromMilliseconds(50);

    const int MaxPacketBytes = 2048;

    readonly StopwatchHeadsetClock _clock = new();
    readonly PacketQueue<(byte[] Bytes, int Length)> _queue;
    readonly Stack<byte[]> _free = new();
    readonly LatencyCounts _lateness;
    readonly SafeFileHandle _from;
    readonly SafeFileHandle _to;
    readonly Thread _thread;
    volatile bool _isStopped;

    /// <param name="lateness">Collects the time by which each packet is released too late.</param>
    public EmulatedDirection(SafeFileHandle from, SafeFileHandle to, PacketLink link, LatencyCounts lateness)
    {
        (_from, _to, _lateness) = (from, to, lateness);
        _queue = new PacketQueue<(byte[] Bytes, int Length)>(link);
        _thread = new Thread(Run) { IsBackground = true, Name = "emulated link" };
        _thread.Start();
    }

    /// <summary>Number of packets that entered the link. Valid after disposal.</summary>
    public int Sent { get; private set; }

    /// <summary>Number of packets that the link lost. Valid after disposal.</summary>
    public int Lost { get; private set; }

    public void Dispose()
    {
        _isStopped = true;
        _thread.Join();
    }

    void Run()
    {
        LinuxCalls.SetAccurateTimeouts();
        while (!_isStopped)
        {
            Wait();
            ReadPackets();
            WritePackets();
        }
    }

    void Wait()
    {
        var wait = _queue.NextArrival - _clock.Now ?? MaxWait;
        if (wait > TimeSpan.Zero) LinuxCalls.WaitReadable(_from, wait < MaxWait ? wait : MaxWait);
    }

    void ReadPackets()
    {
        while (true)
        {
            if (!_free.TryPop(out var packet)) packet = new byte[MaxPacketBytes];
            var length = LinuxCalls.Read(_from, packet);
            if (length > 0)
            {
                Sent++;
                if (_queue.TrySend(_clock.Now, (packet, length))) continue;
                Lost++;
            }
            _free.Push(packet);
            if (length == 0) return;
        }
    }

    void WritePackets()
    {
        while (_queue.TryReceive(_clock.Now, out var packet, out var due))
        {
            LinuxCalls.Write(_to, packet.Bytes, packet.Length);
            _lateness.Add((_clock.Now - due).Ticks * 100);
            _free.Push(packet.Bytes);
        }
    }
}
