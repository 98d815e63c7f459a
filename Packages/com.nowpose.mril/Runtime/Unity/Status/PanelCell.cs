using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>One text of a panel, which is written only when it changes: each new one costs the engine a mesh, and reading it a string.</summary>
    struct PanelCell
    {
        readonly TextMesh _mesh;
        string _shown;

        public PanelCell(TextMesh mesh)
        {
            _mesh = mesh;
            _shown = null;
        }

        public void Show(string text)
        {
            if (text == _shown || _mesh == null) return;
            _mesh.text = text;
            _shown = text;
        }

        /// <param name="top">Upper edge in the parent's units.</param>
        public void MoveTo(float top)
        {
            if (_mesh == null) return;
            var place = _mesh.transform;
            place.localPosition = new Vector3(place.localPosition.x, top, 0);
        }
    }
}
