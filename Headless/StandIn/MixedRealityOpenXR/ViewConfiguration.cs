using System.Collections.Generic;

namespace Microsoft.MixedReality.OpenXR;

public class ViewConfiguration
{
    internal ViewConfiguration(params ReprojectionMode[] supported) => SupportedReprojectionModes = supported;

    /// <summary>Null before the runtime's session has begun, and without the plugin's feature.</summary>
    public static ViewConfiguration Primary { get; internal set; }

    public bool IsActive { get; internal set; } = true;

    public IReadOnlyList<ReprojectionMode> SupportedReprojectionModes { get; }

    /// <summary>Settings of the calls in order, each valid for one frame.</summary>
    internal List<ReprojectionSettings> Set { get; } = new();

    public void SetReprojectionSettings(ReprojectionSettings settings) => Set.Add(settings);
}
