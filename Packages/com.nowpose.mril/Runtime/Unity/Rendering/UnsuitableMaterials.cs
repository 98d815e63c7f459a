using System.Collections.Generic;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Logs materials that cannot show that a pose is not current, each once.</summary>
    sealed class UnsuitableMaterials
    {
        readonly HashSet<Object> _reported = new HashSet<Object>();

        /// <param name="appearance">The component that a click on the logged line selects.</param>
        /// <param name="part">A part that was drawn with its present materials.</param>
        /// <param name="substitute">Material that is drawn instead; null if the part is hidden.</param>
        public void Report(Component appearance, PosePart part, Material substitute)
        {
            if (!part.HasUnsuitableMaterial) return;
            var material = part.UnsuitableMaterial;
            var isMissing = material == null;
            if (!_reported.Add(isMissing ? (Object)part.Renderer : material)) return;
            var name = part.Renderer.name;
            var problem = isMissing ? AppearanceMessages.NoMaterial(name) : AppearanceMessages.NotFadeable(material.name, name);
            var remedy = isMissing ? AppearanceMessages.AssignMaterial : AppearanceMessages.ChangeShader;
            if (substitute != null) ConsoleLog.Info(appearance, AppearanceMessages.Substituted(appearance.name, problem, substitute.name, remedy));
            else ConsoleLog.Warn(appearance, AppearanceMessages.Hidden(appearance.name, problem, remedy));
        }
    }
}
