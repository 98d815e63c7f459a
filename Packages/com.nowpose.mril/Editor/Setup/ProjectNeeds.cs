using System.Collections.Generic;
using System.Linq;

namespace Nowpose.Editor.Setup
{
    /// <summary>Packages that a project needs, with the supported versions. This is the only list of these versions.</summary>
    static class ProjectNeeds
    {
        /// <summary>Name of the Nowpose package.</summary>
        public const string Package = "com.nowpose.mril";

        /// <summary>OpenXR for the Android player for ARM64.</summary>
        public static readonly PackageOrigin OpenXr = PackageOrigin.OfUnity("com.unity.xr.openxr", "1.13.0", isEditorsChoice: true);

        /// <summary>
        /// OpenXR for Universal Windows Platform (HoloLens 2) and for the Android player for x86-64 (Magic Leap 2). Version 1.17 supports neither.
        /// </summary>
        public static readonly PackageOrigin OpenXrBefore117 = PackageOrigin.OfUnity("com.unity.xr.openxr", "1.13.0", below: "1.17.0");

        public static readonly PackageOrigin MixedRealityOpenXr =
            PackageOrigin.Of(ScopedRegistry.Microsoft, "com.microsoft.mixedreality.openxr", "1.11.2", min: "1.11.1");

        /// <summary>
        /// AR Foundation for Microsoft's plugin. Version 6.4 has marker types with the same names. Without the plugin, all versions 5 and 6 are supported.
        /// </summary>
        public static readonly PackageOrigin ArFoundation =
            PackageOrigin.OfUnity("com.unity.xr.arfoundation", "5.1.5", min: "5.0.0", below: "6.4.0");

        public static readonly PackageOrigin InputSystem =
            PackageOrigin.OfUnity("com.unity.inputsystem", "1.7.0", min: "1.5.0", isEditorsChoice: true);

        /// <summary>XR Interaction Toolkit before version 3. Version 3 moved types that MRTK3 uses.</summary>
        public static readonly PackageOrigin XrInteraction =
            PackageOrigin.OfUnity("com.unity.xr.interaction.toolkit", "2.6.3", min: "2.3.0", below: "3.0.0");

        // The address refers to version 2.0.4 by a commit on the branch upm-2, because the tags of the repository contain sources that Unity cannot
        // import.
        public static readonly PackageOrigin NativeWebSocket = PackageOrigin.At(
            "com.endel.nativewebsocket", "https://github.com/endel/NativeWebSocket.git#522f0c3f5c2ef7273737707effaa840c65e20e98", min: "2.0.3");

        /// <summary>Dependencies of the package and of its tests.</summary>
        public static readonly IReadOnlyList<PackageOrigin> Always = new[]
        {
            PackageOrigin.OfUnity("com.unity.nuget.newtonsoft-json", "3.2.1", min: "3.2.1"),
            PackageOrigin.Of(ScopedRegistry.UnityNuGet, "org.nuget.mathnet.numerics", "5.0.0", min: "5.0.0"),
            PackageOrigin.OfUnity("com.unity.test-framework", "1.1.33"),
        };

        /// <summary>Packages of MRTK3, each at the tag of its newest release 3.x. No registry contains them.</summary>
        public static readonly IReadOnlyList<PackageOrigin> Mrtk3 = new[]
        {
            Mrtk("core", "3.3.0"), Mrtk("uxcore", "3.3.0"), Mrtk("standardassets", "3.2.1"), Mrtk("spatialmanipulation", "3.4.0"),
            // The menu uses a button with a checkbox, which the package uxcomponents contains since version 3.3.0.
            Mrtk("uxcomponents", "3.4.0", "3.3.0"), Mrtk("input", "3.3.0"), Mrtk("windowsspeech", "3.0.4"),
        };

        /// <summary>Packages of a project with MRTK3 on a HoloLens 2, in addition to <see cref="Always"/>.</summary>
        public static readonly IReadOnlyList<PackageOrigin> HoloLensWithMrtk3 = new[]
        {
            OpenXrBefore117, MixedRealityOpenXr, ArFoundation, InputSystem, XrInteraction,
            PackageOrigin.At(
                "com.microsoft.mrtk.graphicstools.unity",
                "https://github.com/microsoft/MixedReality-GraphicsTools-Unity.git?path=/com.microsoft.mrtk.graphicstools.unity#v0.8.0",
                min: "0.8.0"),
        }.Concat(Mrtk3).ToArray();

        /// <summary>Returns the supported versions of OpenXR for the player of a project.</summary>
        public static PackageOrigin OpenXrFor(IProjectSettings project) =>
            project.Platform == HeadsetPlatform.HoloLens2 || project.TargetsX64 ? OpenXrBefore117 : OpenXr;

        static PackageOrigin Mrtk(string part, string version, string min = "3.0.0") => PackageOrigin.At(
            "org.mixedrealitytoolkit." + part,
            "https://github.com/MixedRealityToolkit/MixedRealityToolkit-Unity.git?path=/org.mixedrealitytoolkit." + part
            + "#" + part + "-v" + version,
            min, "4.0.0");
    }
}
