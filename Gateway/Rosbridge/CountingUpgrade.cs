using Microsoft.AspNetCore.Http.Features;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Stands before Kestrel's own upgrade so that the WebSocket's bytes are counted on their way in.</summary>
sealed class CountingUpgrade(IHttpUpgradeFeature inner) : IHttpUpgradeFeature
{
    public FragmentCounter Fragments { get; } = new();
    public bool IsUpgradableRequest => inner.IsUpgradableRequest;
    public async Task<Stream> UpgradeAsync() => new CountingStream(await inner.UpgradeAsync(), Fragments);
}
