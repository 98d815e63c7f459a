using UnityEditor;
using UnityEditor.Build;

namespace Nowpose.Editor.Setup
{
    /// <summary>A kind of headset, and the Unity player for it.</summary>
    sealed class HeadsetPlatform
    {
        public static readonly HeadsetPlatform HoloLens2 = new HeadsetPlatform(
            "a HoloLens 2", "Universal Windows Platform", "UWP", NamedBuildTarget.WindowsStoreApps, BuildTarget.WSAPlayer, BuildTargetGroup.WSA);

        /// <summary>Platform of Quest, Magic Leap 2 and other headsets with Android.</summary>
        public static readonly HeadsetPlatform AndroidHeadset = new HeadsetPlatform(
            "an Android headset", "Android", "Android", NamedBuildTarget.Android, BuildTarget.Android, BuildTargetGroup.Android);

        HeadsetPlatform(
            string headset, string player, string shortPlayer, NamedBuildTarget named, BuildTarget target, BuildTargetGroup group)
        {
            Headset = headset;
            Player = player;
            ShortPlayer = shortPlayer;
            Named = named;
            Target = target;
            Group = group;
        }

        /// <summary>Name of the headset with its article, for example "a HoloLens 2".</summary>
        public string Headset { get; }

        /// <summary>Name of the player in Unity's windows and in the list of modules of Unity Hub.</summary>
        public string Player { get; }

        public string ShortPlayer { get; }
        public NamedBuildTarget Named { get; }
        public BuildTarget Target { get; }
        public BuildTargetGroup Group { get; }
    }
}
