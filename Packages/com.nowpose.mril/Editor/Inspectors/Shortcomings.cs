using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Session;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Finds missing references and components that the package's components need.</summary>
    static class Shortcomings
    {
        static readonly IShortcomingRule[] Rules =
        {
            new ReferenceRule(
                typeof(MrilSession), "_settings", null, ShortcomingTexts.Settings,
                _ => PackageAsset.DefaultSettings.Load<SessionSettingsAsset>()),
            SessionRule<RobotRig>(ShortcomingTexts.RigSession), SessionRule<RenderTimeSource>(ShortcomingTexts.ReportSession),
            SessionRule<LatencyProfileLoader>(ShortcomingTexts.CalibratedSession), SessionRule<LatencyNudge>(ShortcomingTexts.CalibratedSession),
            SessionRule<CellPairing>(ShortcomingTexts.PairedSession),
            SessionRule<PoseAppearance>(
                ShortcomingTexts.ShownSession, each => each.SessionOfParts(null, each.GetComponentInParent<RobotRig>()) == null),
            SessionRule<StatusPanel>(ShortcomingTexts.StatusSession), SessionRule<TrackedObject>(ShortcomingTexts.ObjectSession),
            SessionRule<StationaryObject>(ShortcomingTexts.ObjectSession), SessionRule<CellSignal>(ShortcomingTexts.SignalSession),
            SessionRule<ActuatedPart>(ShortcomingTexts.SignalSession), SessionRule<SessionRecording>(ShortcomingTexts.RecordedSession),
            SessionRule<LoadSweep>(ShortcomingTexts.FramesSession), SessionRule<TimestampDisplay>(ShortcomingTexts.FramesSession),
            SessionRule<CellActions>(ShortcomingTexts.ActionsSession),
            RigRule<VirtualGripper>(), RigRule<GripByReach>(), RigRule<PlannedPath>(),
            new ReferenceRule(
                typeof(PoseAppearance), "_substitute", null,
                ShortcomingTexts.Substitute,
                _ => PackageAsset.Hologram.Load<Material>(), appearance => ((PoseAppearance)appearance).NeedsSubstitute),
            new ReferenceRule(
                typeof(StatusPanel), "_cell", null,
                ShortcomingTexts.PanelText,
                panel => panel.GetComponentInChildren<TextMesh>(true)),
            new ReferenceRule(
                typeof(TimestampDisplay), "_light", null, ShortcomingTexts.Light, _ => PackageAsset.Timestamp.Load<Material>()),
            new ReferenceRule(
                typeof(LoadSweep), "_load", null, ShortcomingTexts.Load, SceneSearch.Only<LoadGenerator>,
                sweep => sweep.GetComponentInChildren<LoadGenerator>(true) == null),
            new AppearanceRule(), new OneMoverRule(), new SwitchedSignalRule(),
            new ConditionRule<RobotRig>(IsBesideBase, ShortcomingTexts.RigBesideBase),
            new ConditionRule<BaseAnchor>(anchor => anchor.IsScaledWithMarkers, ShortcomingTexts.ScaledBase),
            new UniqueRule<RobotRig>(
                (rig, other) => IsDisplayed(rig) && IsDisplayed(other) && NamespaceOf(rig) == NamespaceOf(other),
                (_, other) => ShortcomingTexts.SameRobot(other.name)),
            new UniqueRule<StationaryObject>(
                (shown, other) => shown.HasPlaceOf(other), (shown, other) => ShortcomingTexts.SameFrame(other.name, shown.Frame)),
        };

        /// <summary>Returns the problems of components. A problem of several components is returned only once.</summary>
        /// <param name="objects">Components of one type.</param>
        public static IReadOnlyList<Shortcoming> Of(Object[] objects)
        {
            var found = new List<Shortcoming>();
            foreach (var rule in Rules)
            {
                Shortcoming shortcoming = null;
                foreach (var component in objects.OfType<Component>().Where(rule.IsBrokenBy))
                {
                    shortcoming = shortcoming ?? rule.Shortcoming(component);
                    shortcoming.Add(component);
                }
                if (shortcoming != null) found.Add(shortcoming);
            }
            return found;
        }

        static ReferenceRule SessionRule<T>(string message, Func<Component, bool> applies = null) where T : Component =>
            new ReferenceRule(typeof(T), "_session", typeof(MrilSession), message, SceneSearch.Only<MrilSession>, applies);

        static bool IsDisplayed(RobotRig rig) => rig.Shows == RigPose.Displayed && rig.enabled && rig.gameObject.activeInHierarchy;

        // A rig without a namespace shows the session's own robot, to which the settings may give a namespace.
        static string NamespaceOf(RobotRig rig)
        {
            if (rig.RobotNamespace.Length > 0) return rig.RobotNamespace;
            var session = SceneSearch.SessionOf(rig);
            if (session == null) return "";
            if (session.Settings != null) return session.Settings.RobotNamespace;
            var settings = SerialisedField.Referenced<SessionSettingsAsset>(session, "_settings");
            return settings != null ? settings.RobotNamespace : "";
        }

        static bool IsBesideBase(RobotRig rig) => rig.gameObject.GetComponentInParent<BaseAnchor>(true) == null
            && CellPlace.AnchorOf(rig, SceneSearch.SessionOf(rig)) != null;

        static ReferenceRule RigRule<T>() where T : Component =>
            new ReferenceRule(typeof(T), "_rig", typeof(RobotRig), ShortcomingTexts.Rig, SceneSearch.OnlyDisplayedRig);
    }
}
