using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Caches how each material can mark a pose as not current, because reading the tag of a material allocates.</summary>
    sealed class PoseMaterials
    {
        readonly Dictionary<Material, PoseMaterial> _known = new Dictionary<Material, PoseMaterial>();
        readonly List<Material> _list = new List<Material>();

        /// <summary>Material that replaces materials that cannot mark a pose as not current; null if there is none.</summary>
        public Material Substitute { get; private set; }

        /// <summary>Clears the cache, because materials may have new shaders, and sets the substitute.</summary>
        /// <param name="substitute">
        /// New substitute; null if there is none. It is ignored unless its shader declares <c>_Fade</c> and <c>_Hatch</c>.
        /// </param>
        public void Begin(Material substitute)
        {
            _known.Clear();
            Substitute = substitute != null && PoseMaterial.Of(substitute).Means == PoseMeans.Pattern ? substitute : null;
        }

        /// <summary>Gets the materials of a renderer, in a list that the next call overwrites.</summary>
        public List<Material> In(Renderer renderer)
        {
            renderer.GetSharedMaterials(_list);
            return _list;
        }

        /// <summary>Returns how a material can mark a pose as not current.</summary>
        /// <param name="material">The material; null if it is missing.</param>
        public PoseMaterial Of(Material material)
        {
            if (material == null) return PoseMaterial.Unsuitable;
            if (!_known.TryGetValue(material, out var known)) _known.Add(material, known = PoseMaterial.Of(material));
            return known;
        }

        /// <summary>Returns how a renderer with these materials can mark a pose as not current.</summary>
        public PoseMaterial Of(List<Material> materials)
        {
            if (materials.Count == 1) return Of(materials[0]);
            // A property block sets one colour for all materials of a renderer, so Alpha needs a renderer with only one material.
            var all = PoseMaterial.NotNeeded;
            foreach (var material in materials)
            {
                var means = Of(material).Means;
                if (NeedsSubstitute(means)) return PoseMaterial.Unsuitable;
                if (means == PoseMeans.Pattern) all = PoseMaterial.Patterned;
            }
            return all;
        }

        /// <summary>Returns a copy of the materials in which the substitute replaces the materials that cannot mark a pose as not current.</summary>
        public Material[] SubstitutesFor(Material[] own)
        {
            var drawn = new Material[own.Length];
            for (var i = 0; i < own.Length; i++) drawn[i] = NeedsSubstitute(Of(own[i]).Means) ? Substitute : own[i];
            return drawn;
        }

        static bool NeedsSubstitute(PoseMeans means) => means == PoseMeans.None || means == PoseMeans.Alpha;
    }
}
