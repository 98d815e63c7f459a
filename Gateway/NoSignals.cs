namespace Nowpose.Gateway;

/// <summary>A web host lifetime that does not handle Ctrl-C, unlike the default one, because the program handles it itself.</summary>
sealed class NoSignals : IHostLifetime
{
    public Task WaitForStartAsync(CancellationToken cancellationToken) => Task.CompletedTask;
    public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;
}
