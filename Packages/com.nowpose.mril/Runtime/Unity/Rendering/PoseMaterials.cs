using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Caches the properties of the materials of a pose's parts, because reading a material's tag allocates.</summary>
    sealed class PoseMaterials
    {
        readonly Dictionary<Material, PoseMaterial> _known = new Dictionary<Material, PoseMaterial>();
        readonly List<Material> _list = new List<Material>();

        /// <summary>Replaces a material that cannot show that the pose is not current; null for none.</summary>
        public Material Substitute { get; private set; }

        /// <summary>Clears the cache, because a material may have a new shader.</summary>
        /// <param name="substitute">Null for none. A substitute that cannot show the state itself is not used.</param>
        public void Begin(Material substitute)
        {
            _known.Clear();
            Substitute = substitute != null && PoseMaterial.Of(substitute).Means == PoseMeans.Pattern ? substitute : null;
        }

        /// <summary>Gets the renderer's materials; the list is valid until the next call.</summary>
        public List<Material> In(Renderer renderer)
        {
            renderer.GetSharedMaterials(_list);
            return _list;
        }

        /// <param name="material">Null for none.</param>
        public PoseMaterial Of(Material material)
        {
            if (material == null) return PoseMaterial.Helpless;
            if (!_known.TryGetValue(material, out var known)) _known.Add(material, known = PoseMaterial.Of(material));
            return known;
        }

        /// <summary>Determines how a renderer with these materials can show that a pose is not current.</summary>
        public PoseMaterial Of(List<Material> materials)
        {
            if (materials.Count == 1) return Of(materials[0]);
            // A property block has one colour for all materials of a renderer, so Alpha is not possible with several.
            var all = PoseMaterial.NotNeeded;
            foreach (var material in materials)
            {
                var means = Of(material).Means;
                if (NeedsSubstitute(means)) return PoseMaterial.Helpless;
                if (means == PoseMeans.Pattern) all = PoseMaterial.Patterned;
            }
            return all;
        }

        /// <summary>Returns the materials to draw with: those that cannot show the state are replaced.</summary>
        public Material[] SubstitutesFor(Material[] own)
        {
            var drawn = new Material[own.Length];
            for (var i = 0; i < own.Length; i++) drawn[i] = NeedsSubstitute(Of(own[i]).Means) ? Substitute : own[i];
            return drawn;
        }

        static bool NeedsSubstitute(PoseMeans means) => means == PoseMeans.None || means == PoseMeans.Alpha;
    }
}
