using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

/// <summary>Differences between the versions of AR Foundation.</summary>
static class Version6
{
    /// <summary>Whether AR Foundation 6 is installed.</summary>
    internal static bool IsInstalled => ArDevice.Current?.ArFoundation.Major >= 6;

    /// <summary>
    /// Whether the device's report of a new trackable creates an object for it although a script has added the trackable as a component, which then
    /// receives no data and stays pending. Versions 6.3.0, 6.4.0 and 6.5.0 do this, and later patches of 6.3 and 6.4 do not.
    /// </summary>
    internal static bool IgnoresAddedComponents => IsInstalled && ArDevice.Current.ArFoundation.Minor is 3 or 4 or 5;
}
