namespace Nowpose.Gateway;

/// <summary>Leaves Ctrl-C to the host program; the default lifetime of the web host would handle it.</summary>
sealed class NoSignals : IHostLifetime
{
    public Task WaitForStartAsync(CancellationToken cancellationToken) => Task.CompletedTask;
    public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;
}
