using Nowpose.Gateway.Rosbridge;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Hands each ping to the test at once.</summary>
sealed class SentPings(Action<ReadOnlyMemory<byte>> sent) : IPingSender
{
    public Task SendAsync(ReadOnlyMemory<byte> payload)
    {
        sent(payload);
        return Task.CompletedTask;
    }

    public void SendWithNext(ReadOnlyMemory<byte> payload) => sent(payload);
}
