using System;
using System.Collections.Generic;
using Nowpose.Latency;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>The patches of a load, built a few vertices a frame; those that are there already are kept, shown or not.</summary>
    sealed class LoadPatches
    {
        readonly Transform _parent;
        readonly Material _material;
        readonly float _width;
        readonly List<LoadSlot> _slots = new List<LoadSlot>();
        readonly Vector3[] _vertices = new Vector3[LoadMesh.PatchVertices];
        readonly Vector3[] _normals = new Vector3[LoadMesh.PatchVertices];
        readonly int[] _indices = new int[LoadMesh.PatchOf(0, LoadMesh.PatchVertices).Indices];
        LoadPatch _patch;
        int _asked, _building, _filled;

        /// <param name="width">Of the whole wall, in units of the parent.</param>
        public LoadPatches(Transform parent, Material material, float width)
        {
            _parent = parent;
            _material = material;
            _width = width;
            for (var i = 0; i < _normals.Length; i++) _normals[i] = Vector3.back;
        }

        /// <summary>Whether all vertices that were asked for are shown.</summary>
        public bool IsComplete { get; private set; } = true;

        /// <summary>That are drawn at this moment.</summary>
        public int VerticesShown { get; private set; }

        /// <summary>Vertices of the load; what is no part of it is hidden at once.</summary>
        public void Ask(int vertices)
        {
            if (vertices == _asked) return;
            _asked = vertices;
            _filled = 0;
            for (var i = 0; i < _slots.Count; i++) _slots[i].IsShown = Wanted(i) > 0 && _slots[i].Vertices == Wanted(i);
            Count();
        }

        /// <summary>Goes on building.</summary>
        /// <param name="budget">Vertices that may be computed or handed to the GPU in this frame; at least a patch's.</param>
        public void Advance(int budget)
        {
            while (!IsComplete && budget > 0)
            {
                if (_filled == 0) Begin();
                if (_filled < _patch.Vertices)
                {
                    var end = Math.Min(_patch.Vertices, _filled + budget);
                    budget -= end - _filled;
                    Fill(end);
                }
                if (_filled < _patch.Vertices || budget < _patch.Vertices) return;
                budget -= _patch.Vertices;
                Show();
            }
        }

        public void Destroy()
        {
            foreach (var slot in _slots) slot.Destroy();
            _slots.Clear();
        }

        int Wanted(int slot) => slot < LoadMesh.PatchesOf(_asked) ? LoadMesh.PatchOf(slot, _asked).Vertices : 0;

        void Begin()
        {
            _building = 0;
            while (_building < _slots.Count && _slots[_building].Vertices == Wanted(_building)) _building++;
            if (_building == _slots.Count) _slots.Add(new LoadSlot(_parent, _material));
            _patch = LoadMesh.PatchOf(_building, _asked);
        }

        void Fill(int end)
        {
            for (; _filled < end; _filled++)
            {
                _patch.PlaceOf(_filled, out var x, out var y);
                _vertices[_filled] = new Vector3(x * _width, y * _width, 0);
                _patch.WriteTriangles(_filled, _indices);
            }
        }

        void Show()
        {
            _slots[_building].Upload(_vertices, _normals, _patch.Vertices, _indices, _patch.Indices);
            _slots[_building].IsShown = true;
            _filled = 0;
            Count();
        }

        void Count()
        {
            VerticesShown = 0;
            foreach (var slot in _slots)
                if (slot.IsShown) VerticesShown += slot.Vertices;
            IsComplete = VerticesShown == LoadMesh.DrawnOf(_asked);
        }
    }
}
