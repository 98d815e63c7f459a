namespace Microsoft.MixedReality.OpenXR;

public class ViewConfiguration
{
    internal ViewConfiguration(params ReprojectionMode[] supported) => SupportedReprojectionModes = supported;

    /// <summary>The primary view; null before the session of the runtime starts, or if the plug-in's feature is not enabled.</summary>
    public static ViewConfiguration Primary { get; internal set; }

    public bool IsActive { get; internal set; } = true;

    public IReadOnlyList<ReprojectionMode> SupportedReprojectionModes { get; }

    /// <summary>Arguments of all calls of <see cref="SetReprojectionSettings"/>, oldest first. Each is valid for one frame.</summary>
    internal List<ReprojectionSettings> Set { get; } = new();

    public void SetReprojectionSettings(ReprojectionSettings settings) => Set.Add(settings);
}

public enum FrameTime
{
    OnUpdate = 0,
    OnBeforeRender,
}
