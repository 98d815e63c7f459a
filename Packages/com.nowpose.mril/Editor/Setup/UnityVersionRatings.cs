using System;
using System.Linq;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Rates Unity versions. Some were compared with the members that the package uses, and others have known failures.</summary>
    static class UnityVersionRatings
    {
        // Each row applies from its version up to the version of the next row. The failure is the reason why the version does not work with
        // Microsoft's plug-in; null if it works.
        static readonly (Version From, CheckState State, string Words, string Failure)[] Rows =
        {
            (new Version(2021, 3), CheckState.Advice, UnityVersionMessages.Compared2021, null),
            (new Version(2022, 1), CheckState.Advice, UnityVersionMessages.NotCompared, null),
            (new Version(2022, 3), CheckState.Good, UnityVersionMessages.Compared2022, null),
            (new Version(2023, 1), CheckState.Advice, UnityVersionMessages.NotCompared, null),
            (new Version(6000, 0), CheckState.Advice, UnityVersionMessages.Compared6000, null),
            (new Version(6000, 1), CheckState.Advice, UnityVersionMessages.NotCompared, null),
            (new Version(6000, 3), CheckState.Advice, UnityVersionMessages.NotComparedNewest, UnityVersionMessages.PlugInFails),
        };

        /// <summary>Oldest supported version of Unity.</summary>
        public static string Oldest => Rows[0].From.ToString();

        /// <summary>Oldest patch of Unity 2021.3 that the packages of MRTK3 accept.</summary>
        public static Version OldestForMrtk3 { get; } = new Version(2021, 3, 26);

        /// <summary>Rates a version of Unity.</summary>
        /// <param name="withMicrosoft">Whether the project uses Microsoft's Mixed Reality OpenXR, as each project for a HoloLens 2 does.</param>
        public static CheckResult Judge(UnityVersion version, bool withMicrosoft)
        {
            var row = Rows.LastOrDefault(r => version.Number >= r.From);
            if (row.From == null) return new CheckResult(CheckState.Missing, UnityVersionMessages.TooOld(version, Oldest));
            return withMicrosoft && row.Failure != null
                ? new CheckResult(CheckState.Missing, version + ": " + row.Failure)
                : new CheckResult(row.State, version + ": " + row.Words);
        }
    }
}
