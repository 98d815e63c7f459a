using UnityEngine.XR.ARFoundation;

namespace Microsoft.MixedReality.OpenXR.ARFoundation;

public static class AnchorManagerExtensions
{
    public static Task<XRAnchorStore> LoadAnchorStoreAsync(this ARAnchorManager anchorManager) => XRAnchorStore.Loading(anchorManager.subsystem);
}
