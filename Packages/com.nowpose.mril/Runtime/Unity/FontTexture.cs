using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Supplies a TextMesh that uses the shader <c>Nowpose/Text</c> with the texture of its font. Updates it when the font replaces its texture.
    /// </summary>
    /// <remarks>
    /// A font's own material draws text in front of all objects and does not write depth, so the package's text objects use another material. The
    /// letters are still in the texture of the font's material. This component sets the texture through a property block, because text objects with
    /// different fonts may share a material.
    /// </remarks>
    [AddComponentMenu("Nowpose/Font Texture")]
    [ExecuteAlways]
    [RequireComponent(typeof(TextMesh))]
    [DisallowMultipleComponent]
    public sealed class FontTexture : MonoBehaviour
    {
        static readonly int TextureId = Shader.PropertyToID("_MainTex");

        [SerializeField, Tooltip("Material of the font, a sub-asset of the font. Its texture contains the letters. It must belong to the font of "
            + "the Text Mesh.")]
        Material _fontMaterial = null;

        Renderer _renderer;
        MaterialPropertyBlock _block;
        Texture _shown;

        // The editor calls Reset for a new component. At that time, the renderer of the TextMesh still has the font's own material.
        void Reset()
        {
            var renderer = GetComponent<Renderer>();
            if (renderer != null) _fontMaterial = renderer.sharedMaterial;
        }

        void OnEnable()
        {
            _renderer = GetComponent<Renderer>();
            _shown = null;
            if (_fontMaterial == null && Application.isPlaying)
                ConsoleLog.Fail(this, ComponentMessages.NoFontMaterial(name));
            Apply();
        }

        void LateUpdate() => Apply();

        void Apply()
        {
            if (_fontMaterial == null || _renderer == null) return;
            var texture = _fontMaterial.mainTexture;
            if (texture == null || ReferenceEquals(texture, _shown)) return;
            _shown = texture;
            _block ??= new MaterialPropertyBlock();
            _renderer.GetPropertyBlock(_block);
            _block.SetTexture(TextureId, texture);
            _renderer.SetPropertyBlock(_block);
        }
    }
}
