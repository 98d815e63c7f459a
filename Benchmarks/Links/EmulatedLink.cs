using System.Diagnostics;
using Nowpose.Benchmarks.Load;

namespace Nowpose.Benchmarks.Links;

/// <summary>Creates a network namespace for the gateway and one for the headset. An emulated link is their only connection.</summary>
sealed class EmulatedLink : IDisposable
{
    // Addresses from the range that RFC 2544 reserves for benchmarks.
    public const string GatewayAddress = "198.18.0.1";
    const string HeadsetAddress = "198.18.0.2";
    const string PrefixLength = "/30";

    readonly NetworkNamespace _gateway;
    readonly NetworkNamespace _headset;
    readonly LatencyCounts _lateness = new();
    EmulatedDirection _up;
    EmulatedDirection _down;

    EmulatedLink(NetworkNamespace gateway, NetworkNamespace headset) => (_gateway, _headset) = (gateway, headset);

    /// <summary>Time by which packets were released too late.</summary>
    public LatencyCounts Lateness => _lateness;

    /// <summary>Number of packets that entered the link in both directions. Valid after the link has stopped.</summary>
    public int Sent => _up.Sent + _down.Sent;

    /// <summary>Number of packets that the link lost in both directions. Valid after the link has stopped.</summary>
    public int Lost => _up.Lost + _down.Lost;

    /// <exception cref="IOException">The machine does not support network namespaces or TUN devices, or the user has no permission.</exception>
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

    /// <summary>Starts to transfer packets. The first stall is counted from this time.</summary>
    /// <returns>Headset time at the start of the link.</returns>
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
