using System.Diagnostics;
using Nowpose.Benchmarks.Load;
using Nowpose.Simulation;

namespace Nowpose.Benchmarks.Links;

/// <summary>Two network namespaces, the gateway's and the headset's, and nothing between them but an emulated link.</summary>
sealed class EmulatedLink : IDisposable
{
    // Of the range that RFC 2544 sets aside for benchmarks.
    public const string GatewayAddress = "198.18.0.1";
    const string HeadsetAddress = "198.18.0.2";
    const string PrefixLength = "/30";

    readonly NetworkNamespace _gateway;
    readonly NetworkNamespace _headset;
    readonly LatencyCounts _lateness = new();
    EmulatedDirection _up;
    EmulatedDirection _down;

    EmulatedLink(NetworkNamespace gateway, NetworkNamespace headset) => (_gateway, _headset) = (gateway, headset);

    /// <summary>How late packets were released.</summary>
    public LatencyCounts Lateness => _lateness;

    /// <summary>Packets that entered the link, in both directions. Read it when stopped.</summary>
    public int Sent => _up.Sent + _down.Sent;

    /// <summary>Packets that the link lost, in both directions. Read it when stopped.</summary>
    public int Lost => _up.Lost + _down.Lost;

    /// <exception cref="IOException">This machine or this user cannot have network namespaces or TUN devices.</exception>
    public static EmulatedLink Create()
    {
        var gateway = NetworkNamespace.Create("gateway", GatewayAddress + PrefixLength);
        try
        {
            return new EmulatedLink(gateway, NetworkNamespace.Create("headset", HeadsetAddress + PrefixLength));
        }
        catch
        {
            gateway.Dispose();
            throw;
        }
    }

    public ProcessStartInfo InGateway(params string[] command) => _gateway.Inside(command);

    public ProcessStartInfo InHeadset(params string[] command) => _headset.Inside(command);

    /// <summary>Begins to carry packets; before, none passes. Stalls are counted from now on.</summary>
    /// <returns>When the link began.</returns>
    public HeadsetTime Start(LinkProfile profile, int seed, bool keepsOrder)
    {
        var start = new StopwatchHeadsetClock().Now;
        _up = new EmulatedDirection(_headset.Tun, _gateway.Tun, new PacketLink(profile, start, seed, keepsOrder), _lateness);
        _down = new EmulatedDirection(_gateway.Tun, _headset.Tun, new PacketLink(profile, start, seed + 1, keepsOrder), _lateness);
        return start;
    }

    public void Stop()
    {
        _up?.Dispose();
        _down?.Dispose();
    }

    public void Dispose()
    {
        Stop();
        _headset.Dispose();
        _gateway.Dispose();
    }
}
