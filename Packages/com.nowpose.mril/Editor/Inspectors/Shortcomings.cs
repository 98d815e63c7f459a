using System.Collections.Generic;
using System.Linq;
using Nowpose.Editor.Messages;
using Nowpose.Unity;
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
            new ReferenceRule(
                typeof(RobotRig), "_session", typeof(MrilSession),
                ShortcomingTexts.RigSession, SceneSearch.Only<MrilSession>),
            new ReferenceRule(
                typeof(RenderTimeSource), "_session", typeof(MrilSession),
                ShortcomingTexts.ReportSession, SceneSearch.Only<MrilSession>),
            new ReferenceRule(
                typeof(LatencyProfileLoader), "_session", typeof(MrilSession),
                ShortcomingTexts.CalibratedSession, SceneSearch.Only<MrilSession>),
            new ReferenceRule(
                typeof(LatencyNudge), "_session", typeof(MrilSession),
                ShortcomingTexts.CalibratedSession, SceneSearch.Only<MrilSession>),
            new ReferenceRule(
                typeof(CellPairing), "_session", typeof(MrilSession),
                ShortcomingTexts.PairedSession, SceneSearch.Only<MrilSession>),
            new ReferenceRule(
                typeof(PoseAppearance), "_session", typeof(MrilSession),
                ShortcomingTexts.ShownSession, SceneSearch.Only<MrilSession>),
            new ReferenceRule(
                typeof(PoseAppearance), "_substitute", null,
                ShortcomingTexts.Substitute,
                _ => PackageAsset.Hologram.Load<Material>(), appearance => ((PoseAppearance)appearance).NeedsSubstitute),
            new ReferenceRule(
                typeof(StatusPanel), "_session", typeof(MrilSession),
                ShortcomingTexts.StatusSession, SceneSearch.Only<MrilSession>),
            new ReferenceRule(
                typeof(StatusPanel), "_cell", null,
                ShortcomingTexts.PanelText,
                panel => panel.GetComponentInChildren<TextMesh>(true)),
            new ReferenceRule(
                typeof(VirtualGripper), "_rig", typeof(RobotRig),
                ShortcomingTexts.Rig, SceneSearch.OnlyDisplayedRig),
            new ReferenceRule(
                typeof(GripByReach), "_rig", typeof(RobotRig),
                ShortcomingTexts.Rig, SceneSearch.OnlyDisplayedRig),
            new ReferenceRule(
                typeof(PlannedPath), "_rig", typeof(RobotRig),
                ShortcomingTexts.Rig, SceneSearch.OnlyDisplayedRig),
            new AppearanceRule(),
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
    }
}
