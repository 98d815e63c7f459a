namespace Nowpose.Gateway;

/// <summary>Leaves Ctrl-C to the program the gateway runs in; the host's own lifetime would take it.</summary>
sealed class NoSignals : IHostLifetime
{
    public Task WaitForStartAsync(CancellationToken cancellationToken) => Task.CompletedTask;
    public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;
}
