using System.Collections.Generic;
using System.Linq;
using Nowpose.Unity;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Finds missing references of the package's components.</summary>
    static class Shortcomings
    {
        static readonly ReferenceRule[] Rules =
        {
            new ReferenceRule(
                typeof(MrilSession), "_settings", null, "It has no settings and cannot start. Assign settings, or let a script provide them.",
                _ => PackageAsset.DefaultSettings.Load<SessionSettingsAsset>()),
            new ReferenceRule(
                typeof(RobotRig), "_session", typeof(MrilSession),
                "There is no session on this object or a parent. Assign one, or let a script bind and move the rig.", Only<MrilSession>),
            new ReferenceRule(
                typeof(RenderTimeSource), "_session", typeof(MrilSession),
                "There is no session on this object or a parent for the report. Assign one.", Only<MrilSession>),
            new ReferenceRule(
                typeof(LatencyProfileLoader), "_session", typeof(MrilSession),
                "No session on this object or a parent to calibrate. Assign one.", Only<MrilSession>),
            new ReferenceRule(
                typeof(LatencyNudge), "_session", typeof(MrilSession),
                "No session on this object or a parent to calibrate. Assign one.", Only<MrilSession>),
            new ReferenceRule(
                typeof(CellPairing), "_session", typeof(MrilSession),
                "There is no session on this object or a parent. Assign the session to set up.", Only<MrilSession>),
            new ReferenceRule(
                typeof(PoseAppearance), "_session", typeof(MrilSession),
                "There is no session on this object or a parent. Assign the session whose pose is shown.", Only<MrilSession>),
            new ReferenceRule(
                typeof(PoseAppearance), "_substitute", null,
                "Some parts have materials that cannot fade, because their shaders lack _Hatch or _Fade. They are hidden while the "
                + "pose is not current. Assign a substitute, or add NowposePose.hlsl to their shaders.",
                _ => PackageAsset.Hologram.Load<Material>(), appearance => ((PoseAppearance)appearance).NeedsSubstitute),
            new ReferenceRule(
                typeof(StatusPanel), "_session", typeof(MrilSession),
                "There is no session on this object or a parent. Assign the session whose status is shown.", Only<MrilSession>),
            new ReferenceRule(
                typeof(StatusPanel), "_cell", null,
                "It has no text to copy. Assign a child text, whose font, material, style and colour apply to the whole panel.",
                panel => panel.GetComponentInChildren<TextMesh>(true)),
            new ReferenceRule(
                typeof(VirtualGripper), "_rig", typeof(RobotRig),
                "There is no rig on a parent. Move the object below a rig, or assign a rig.", Only<RobotRig>),
        };

        /// <summary>Returns the missing references of components. A reference that several components lack is returned only once.</summary>
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

        // Returns the only component of a type in the scene (or open prefab) of a component; null if there is none or more than one.
        static Object Only<T>(Component component) where T : Component
        {
            var all = component.gameObject.scene.GetRootGameObjects().SelectMany(root => root.GetComponentsInChildren<T>(true)).ToArray();
            return all.Length == 1 ? all[0] : null;
        }
    }
}
