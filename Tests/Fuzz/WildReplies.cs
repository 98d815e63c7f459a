using Nowpose.Headless.Tests.Network;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Creates replies of a sync server, about half of which are correct. Not thread-safe.</summary>
sealed class WildReplies(int seed)
{
    // Sets the control time later than the time stamps of the messages, because later time stamps would be rejected without further checks.
    const long AheadNs = 1_700_000_100_000_000_000;

    readonly Random _random = new(seed);

    public byte[] Answer(SyncFrame request)
    {
        if (_random.Next(2) == 0) return FakeSyncServer.Bytes(SyncFrame.Reply(request, request.T1Ns + AheadNs, request.T1Ns + AheadNs + 100_000,
            true, default, 100));
        return _random.Next(10) == 0
            ? FrameMutator.Next(_random) : FakeSyncServer.Bytes(FrameMutator.Reply(_random, request.Sequence, request.T1Ns));
    }
}
